#include "raylab/accelerator/trace_rays.h"

#include "raylab/base/progress.h"
#include "raylab/base/thread_pool.h"
#include "raylab/base/tiles.h"
#include "raylab/scene/needs.h"
#include "raylab/scene/scene.h"

#include <chrono>
#include <limits>
#include <mutex>

namespace raylab {

namespace {

// Rays in a piece of work: a small fraction of a second by brute force on 10^5 triangles.
constexpr std::size_t grain = 1024;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

HitRecord nearest(const Accelerator& accelerator, const Ray& ray, Traversal& traversal) {
    const auto hit = accelerator.closest(ray, traversal);
    if (!hit) return {-1, std::numeric_limits<float>::infinity()};
    return {static_cast<std::int32_t>(hit->primitive.part), cast<float>(hit->t)};
}

HitRecord any(const Accelerator& accelerator, const Ray& ray, Traversal& traversal) {
    return {accelerator.occluded(ray, traversal) ? 0 : -1, 0.0f};
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
    const auto answer = options.question == RayQuestion::any ? any : nearest;
    const auto start = Clock::now();
    for_each_piece(rays.size(), grain, result.threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i) result.hits[i] = answer(*accelerator, rays[i], traversal);
        const std::lock_guard lock(guards_counts);
        result.counts.add(traversal);
        progress.step();
    });
    result.seconds = seconds_since(start);
    return result;
}

}  // namespace raylab
