#include "rays.h"

#include "meshes.h"
#include "peer.h"
#include "ray_maker.h"

#include "raylab/base/error.h"
#include "raylab/base/tiles.h"

#include <algorithm>

namespace raylab::bench {

namespace {

// Checks hits of the reference structure against the list. The tests show that all structures agree with it; here as
// many rays are checked as half a second permits.
void check_by_list(const Scene& scene, const std::vector<Ray>& rays, const std::vector<std::int32_t>& triangles) {
    constexpr std::size_t affordable_tests = 30'000'000;
    const std::size_t wanted = std::clamp<std::size_t>(affordable_tests / mesh_of(scene).faces.size(), 1, rays.size());
    const auto list = make_accelerator("list", scene);
    Traversal traversal;
    for (std::size_t k = 0; k < wanted; ++k) {
        const std::size_t i = k * rays.size() / wanted;
        const auto hit = list->closest(rays[i], traversal);
        if ((hit ? static_cast<std::int32_t>(hit->primitive.part) : none) == triangles[i]) continue;
        throw Error("ray " + std::to_string(i) + ": expected the same answer of list and bvh, found two");
    }
}

std::vector<std::int32_t> nearest(const Scene& scene, const Accelerator& exact, const std::vector<Ray>& rays) {
    std::vector<std::int32_t> triangles(rays.size(), none);
    for_each_piece(rays.size(), 4096, 0, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i)
            if (const auto hit = exact.closest(rays[i], traversal))
                triangles[i] = static_cast<std::int32_t>(hit->primitive.part);
    });
    check_by_list(scene, rays, triangles);
    return triangles;
}

struct Kind {
    const char* name;
    RayQuestion question;
    std::vector<Ray> (RayMaker::*rays)() const;
};

constexpr Kind kinds[] = {
    {"primary", RayQuestion::nearest, &RayMaker::primary},   {"bounce", RayQuestion::nearest, &RayMaker::bounce},
    {"segments", RayQuestion::nearest, &RayMaker::segments}, {"bounce_any", RayQuestion::any, &RayMaker::bounce},
    {"shadow", RayQuestion::any, &RayMaker::shadow},         {"segments_any", RayQuestion::any, &RayMaker::segments},
    {"aimed", RayQuestion::nearest, &RayMaker::aimed}};

const Kind& kind(const std::string& name) {
    const auto found = std::ranges::find(kinds, name, &Kind::name);
    if (found != std::end(kinds)) return *found;
    std::string known;
    for (const Kind& one : kinds) known += (known.empty() ? "" : ", ") + std::string(one.name);
    throw Error("expected a kind of rays (" + known + "), found \"" + name + "\"");
}

}  // namespace

std::vector<std::string> usual_rays() {
    std::vector<std::string> names;
    for (const Kind& one : kinds)
        if (one.rays != &RayMaker::aimed) names.push_back(one.name);
    return names;
}

void refuse_unknown_rays(const std::string& name) { kind(name); }

std::vector<RaySet> ray_sets(const Scene& scene, const std::vector<std::string>& names, int size) {
    const auto exact = make_accelerator("bvh", scene);
    const RayMaker maker(scene, *exact, size);
    std::vector<std::pair<decltype(Kind::rays), std::shared_ptr<const Rays>>> made;  // two queries share their rays
    std::vector<RaySet> sets;
    for (const std::string& name : names) {
        const Kind& wanted = kind(name);
        auto found = std::ranges::find(made, wanted.rays, [](const auto& one) { return one.first; });
        if (found == made.end()) {
            auto rays = (maker.*wanted.rays)();
            auto truth = nearest(scene, *exact, rays);
            made.emplace_back(wanted.rays, std::make_shared<const Rays>(std::move(rays), std::move(truth)));
            found = std::prev(made.end());
        }
        sets.push_back({name, wanted.question, found->second});
    }
    return sets;
}

}  // namespace raylab::bench
