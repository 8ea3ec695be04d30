#include "raylab/accelerator/wide/wide_walk.h"

#include <array>
#include <cassert>
#include <cstdint>

// This file is compiled once for every instruction set that Highway names; which one runs is decided at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raylab/accelerator/wide/wide_walk.cpp"
#include <hwy/foreach_target.h>

#include "raylab/accelerator/wide/wide_boxes-inl.h"
#include "raylab/accelerator/wide/wide_faults-inl.h"
#include "raylab/accelerator/wide/wide_leaf-inl.h"
#include "raylab/accelerator/wide/wide_ray-inl.h"
#include "raylab/accelerator/wide/wide_stack-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

template <WideTest test>
HWY_INLINE void walk_with(const WideNodes& tree, WideRay& ray, const WideQuery& query, WideLeaves& leaves,
                          Traversal& traversal) {
    if (tree.nodes.empty()) return;
    Stack::Places places;
    Stack stack(tree, places);
    alignas(32) std::array<float, wide> entries;
    const BoxLanes boxes(ray);
    std::uint64_t steps = 0, triangles = 0;
    WideChild next = WideChild::node(0);
    while (true) {
        if constexpr (test == WideTest::nearest_told) leaves.came_to(next);
        if (next.is_node()) {
            const WideNode& node = tree.nodes[next.first()];
            ++steps;
            if (const std::uint32_t met = boxes.meet(node, ray.box_end, entries.data())) {
                next = stack.keep(node, entries.data(), met);
                continue;
            }
        } else if (next.kind() == WideChild::Kind::triangles) {
            triangles += next.count();
            if constexpr (test == WideTest::plain) {
                ask_plainly(tree, ray, query.ray, next, leaves);
            } else {
                ask<test>(tree, ray, query, next, leaves);
            }
        } else {
            ray.end_by(leaves.others(next));
        }
        Waiting waiting;
        do {
            if (stack.is_empty()) {
                traversal.steps += steps;
                traversal.box_tests += wide * steps;
                traversal.primitive_tests += triangles;
                if constexpr (test == WideTest::nearest || test == WideTest::nearest_told)
                    locate_nearest(tree, query, leaves);
                return;
            }
            waiting = stack.pop();
        } while (!(waiting.entry() <= ray.box_end));
        next = waiting.child();
    }
}

template <WideTest test>
HWY_INLINE bool walk_if_tame(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal) {
    WideRay ray(query.ray, tree, query.end);
    if (ray.tame) walk_with<test>(tree, ray, query, leaves, traversal);
    return ray.tame;
}

bool walk_nearest(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal) {
    return walk_if_tame<WideTest::nearest>(tree, query, leaves, traversal);
}

bool walk_nearest_told(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal) {
    return walk_if_tame<WideTest::nearest_told>(tree, query, leaves, traversal);
}

bool walk_any(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal) {
    return walk_if_tame<WideTest::any>(tree, query, leaves, traversal);
}

bool walk_plain(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal) {
    return walk_if_tame<WideTest::plain>(tree, query, leaves, traversal);
}

CompiledFaults walk_faults() { return faults_of_lanes(); }

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab {

HWY_EXPORT(walk_nearest);
HWY_EXPORT(walk_any);
HWY_EXPORT(walk_nearest_told);
HWY_EXPORT(walk_plain);
HWY_EXPORT(walk_faults);

WideWalks best_wide_walks() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const std::size_t best = hwy::GetChosenTarget().GetIndex();
    const WideWalks walks{HWY_DISPATCH_TABLE(walk_nearest)[best], HWY_DISPATCH_TABLE(walk_any)[best],
                          HWY_DISPATCH_TABLE(walk_nearest_told)[best], HWY_DISPATCH_TABLE(walk_plain)[best],
                          HWY_DISPATCH_TABLE(walk_faults)[best]};
    assert(walks.faults() == CompiledFaults{} && "wide_walk.cpp is compiled with cmake/flags.cmake's flags");
    return walks;
}

}  // namespace raylab
#endif
