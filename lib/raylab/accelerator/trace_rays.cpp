#include "raylab/accelerator/trace_rays.h"

#include "raylab/base/progress.h"
#include "raylab/base/thread_pool.h"
#include "raylab/base/tiles.h"
#include "raylab/scene/needs.h"
#include "raylab/scene/scene.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <mutex>
#include <vector>

namespace raylab {

namespace {

// Rays in a piece of work: a small fraction of a second by brute force on 10^5 triangles.
constexpr std::size_t grain = 1024;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

using Hits = std::vector<HitRecord>;

Hits nearest(const Accelerator& accelerator, std::span<const Ray> rays, Traversal& traversal) {
    Hits hits;
    hits.reserve(rays.size());
    for (const auto& hit : accelerator.closest_of(rays, traversal))
        hits.push_back(hit ? HitRecord{static_cast<std::int32_t>(hit->primitive.part), cast<float>(hit->t)}
                           : HitRecord{-1, std::numeric_limits<float>::infinity()});
    return hits;
}

Hits any(const Accelerator& accelerator, std::span<const Ray> rays, Traversal& traversal) {
    Hits hits;
    hits.reserve(rays.size());
    for (const bool hit : accelerator.occluded_of(rays, traversal)) hits.push_back({hit ? 0 : -1, 0.0f});
    return hits;
}

}  // namespace

TraceResult trace_rays(std::shared_ptr<const Mesh> mesh, std::span<const Ray> rays, const TraceOptions& options) {
    Scene scene;
    scene.objects.push_back({.shape = std::move(mesh)});
    TraceResult result{.accelerator = chosen_accelerator(options.accelerator, scene, static_cast<double>(rays.size())),
                       .threads = thread_count(options.threads)};
    const auto build_start = Clock::now();
    const auto accelerator = make_accelerator(result.accelerator, scene, {.threads = result.threads});
    result.build_seconds = seconds_since(build_start);
    result.bytes = accelerator->bytes();

    result.hits.resize(rays.size());
    std::mutex guards_counts;
    Progress progress("tracing", (rays.size() + grain - 1) / grain);
    const auto answers = options.question == RayQuestion::any ? any : nearest;
    const auto start = Clock::now();
    for_each_piece(rays.size(), grain, result.threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        std::ranges::copy(answers(*accelerator, rays.subspan(begin, end - begin), traversal),
                          result.hits.begin() + static_cast<std::ptrdiff_t>(begin));
        const std::lock_guard lock(guards_counts);
        result.counts.add(traversal);
        progress.step();
    });
    result.seconds = seconds_since(start);
    return result;
}

}  // namespace raylab
