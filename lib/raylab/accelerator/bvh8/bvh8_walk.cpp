#include "raylab/accelerator/bvh8/bvh8_walk.h"

#include "raylab/accelerator/bvh8/bvh8_instruction_set.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <type_traits>

// This file is compiled once for every instruction set that Highway names; which one runs is decided at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raylab/accelerator/bvh8/bvh8_walk.cpp"
#include <hwy/foreach_target.h>

#include "raylab/accelerator/bvh8/bvh8_box_ray-inl.h"
#include "raylab/accelerator/bvh8/bvh8_boxes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_faults-inl.h"
#include "raylab/accelerator/bvh8/bvh8_leaf-inl.h"
#include "raylab/accelerator/bvh8/bvh8_ray-inl.h"
#include "raylab/accelerator/bvh8/bvh8_stack-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

template <Bvh8Test test>
HWY_INLINE void walk_with(const Bvh8Nodes& tree, Bvh8Ray& ray, const Bvh8Query& query, Bvh8Leaves& leaves,
                          Traversal& traversal) {
    if (tree.nodes.empty()) return;
    constexpr bool any_will_do = test == Bvh8Test::any || test == Bvh8Test::any_candidate;
    using Stack = std::conditional_t<any_will_do, InOrder, NearestFirst>;
    typename Stack::Places places;
    Stack waiting(tree, places);
    alignas(32) std::array<float, bvh8_width> entries;
    const BoxRows rows(tree, ray.boxes);
    const auto* const nodes = reinterpret_cast<const std::byte*>(tree.nodes.data());
    std::uint64_t steps = 0, triangles = 0;
    Bvh8Child next = Bvh8Child::node(0);
    const auto come_to = [&](Bvh8Child child) HWY_ATTR {
        if constexpr (test == Bvh8Test::nearest_told) leaves.came_to(child);
    };
    while (true) {
        // A loop of its own, so that the ray's numbers stay in registers: where there are 32, that saves 3 to 4 %.
        if (next.is_node()) {
            const BoxLanes boxes(ray.boxes, rows, ray.start, ray.end);
            const std::int32_t latest_entry = ray.latest_entry();
            do {
                come_to(next);
                ++steps;
                const std::size_t offset = next.node_offset();
                const std::uint32_t hit_found = boxes.hit_mask(offset, entries.data());
                next = hit_found == 0 ? waiting.pop(latest_entry)
                                      : waiting.keep(*reinterpret_cast<const Bvh8Node*>(nodes + offset), entries.data(),
                                                     hit_found);
            } while (next.is_node());
        }
        if (next.is_none()) break;
        come_to(next);
        if (next.kind() == Bvh8Child::Kind::triangles) {
            triangles += next.count();
            if constexpr (test == Bvh8Test::plain) {
                ask_plainly(tree, ray, query.ray, next, leaves);
            } else {
                ask<test>(tree, ray, query, next, leaves);
            }
        } else {
            ray.end_by(leaves.others(next));
        }
        // Where any hit will do, the first one ends the walk, and until then the ray's end stays where it was.
        if (any_will_do && ray.end < ray.start) break;
        next = waiting.pop(ray.latest_entry());
    }
    traversal.steps += steps;
    traversal.box_tests += bvh8_width * steps;
    traversal.primitive_tests += triangles;
    if constexpr (test == Bvh8Test::nearest || test == Bvh8Test::nearest_told) locate_nearest(tree, query, leaves);
}

template <Bvh8Test test>
HWY_INLINE bool walk_if_it_fits_floats(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves,
                                       Traversal& traversal) {
    // Constants, where the ray itself is meant, so that they cost nothing.
    const float displacement = is_of_candidates(test) ? query.displacement : 0;
    const BoxRay boxes(query.ray, tree, displacement);
    Bvh8Ray ray(query.ray, boxes, query.end);
    if (boxes.fits_floats) walk_with<test>(tree, ray, query, leaves, traversal);
    return boxes.fits_floats;
}

bool walk_nearest(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::nearest>(tree, query, leaves, traversal);
}

bool walk_nearest_told(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::nearest_told>(tree, query, leaves, traversal);
}

bool walk_any(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::any>(tree, query, leaves, traversal);
}

bool walk_candidates(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::candidates>(tree, query, leaves, traversal);
}

bool walk_any_candidate(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::any_candidate>(tree, query, leaves, traversal);
}

bool walk_plain(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::plain>(tree, query, leaves, traversal);
}

CompiledFaults walk_faults() { return faults_of_lanes(); }

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab {

HWY_EXPORT(walk_nearest);
HWY_EXPORT(walk_any);
HWY_EXPORT(walk_nearest_told);
HWY_EXPORT(walk_candidates);
HWY_EXPORT(walk_any_candidate);
HWY_EXPORT(walk_plain);
HWY_EXPORT(walk_faults);

Bvh8Walks best_bvh8_walks() {
    const std::size_t best = best_instruction_set();
    const Bvh8Walks walks{HWY_DISPATCH_TABLE(walk_nearest)[best],       HWY_DISPATCH_TABLE(walk_any)[best],
                          HWY_DISPATCH_TABLE(walk_nearest_told)[best],  HWY_DISPATCH_TABLE(walk_candidates)[best],
                          HWY_DISPATCH_TABLE(walk_any_candidate)[best], HWY_DISPATCH_TABLE(walk_plain)[best],
                          HWY_DISPATCH_TABLE(walk_faults)[best]};
    assert(walks.faults() == CompiledFaults{} && "bvh8_walk.cpp is compiled with cmake/flags.cmake's flags");
    return walks;
}

}  // namespace raylab
#endif
