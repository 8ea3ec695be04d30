#include "raylab/accelerator/kd8/kd8_walk.h"

#include "raylab/accelerator/bvh8/bvh8_instruction_set.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

// This file is compiled once for every instruction set that Highway names; which one runs is decided at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raylab/accelerator/kd8/kd8_walk.cpp"
#include <hwy/foreach_target.h>

#include "raylab/accelerator/bvh8/bvh8_box_ray-inl.h"
#include "raylab/accelerator/bvh8/bvh8_faults-inl.h"
#include "raylab/accelerator/bvh8/bvh8_leaf-inl.h"
#include "raylab/accelerator/bvh8/bvh8_ray-inl.h"
#include "raylab/accelerator/kd8/kd8_planes-inl.h"
#include "raylab/accelerator/kd8/kd8_stack-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// The ray's way through the box around all cells.
HWY_INLINE VisitedCell whole(const Kd8Cells& cells, const BoxRay& ray, float start, float end) {
    VisitedCell way(start, end, cells.root);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float low = cells.bounds.min[static_cast<int>(axis)], high = cells.bounds.max[static_cast<int>(axis)];
        const bool is_backward = ray.inverse[axis] < 0;
        const auto t = [&](float plane, const float* start_of) HWY_ATTR {
            constexpr hn::CappedTag<float, 1> one;
            return hn::GetLane(
                BoxRay::t_at(hn::Set(one, plane), hn::Set(one, start_of[axis]), hn::Set(one, ray.inverse[axis])));
        };
        way.entry = std::max(way.entry, t(is_backward ? high : low, ray.near_start));
        way.exit = std::min(way.exit, t(is_backward ? low : high, ray.far_start));
    }
    return way;
}

template <Bvh8Test test>
HWY_INLINE void walk_cells(const Kd8Cells& cells, const Bvh8Nodes& contents, Bvh8Ray& ray, const Bvh8Query& query,
                           Bvh8Leaves& leaves, Traversal& traversal) {
    WaitingCells::Places places;
    WaitingCells waiting(cells, contents, places);
    Kd8Ranges ranges;
    const PlaneLanes planes(ray.boxes);
    const auto* const nodes = reinterpret_cast<const std::byte*>(cells.nodes.data());
    std::uint64_t steps = 0, triangles = 0;
    const auto come_to = [&](Bvh8Child child) HWY_ATTR {
        if constexpr (test == Bvh8Test::nearest_told) leaves.came_to(child);
    };
    const auto ask_leaf = [&](Bvh8Child leaf) HWY_ATTR {
        come_to(leaf);
        if (leaf.kind() == Bvh8Child::Kind::triangles) {
            triangles += leaf.count();
            ray.prepare_for_triangles(query.ray, contents, 0);
            ask<test>(contents, ray, query, leaf, leaves);
        } else {
            ray.end_by(leaves.others(leaf));
        }
    };
    // Where any hit will do, the first one ends the walk, and until then the ray's end stays where it was.
    const auto is_over = [&]() HWY_ATTR { return test == Bvh8Test::any && ray.end < ray.start; };
    VisitedCell at = whole(cells, ray.boxes, ray.start, ray.end);
    while (true) {
        while (at.child.is_node()) {
            come_to(Bvh8Child::node(at.child.first()));
            ++steps;
            const Kd8Node& node = *reinterpret_cast<const Kd8Node*>(nodes + at.child.node_offset());
            const std::uint32_t hit_found = planes.hit_mask(node, at.entry, std::min(at.exit, ray.end), ranges);
            at = hit_found == 0 ? waiting.pop(ray.latest_entry()) : waiting.keep(node, ranges, hit_found);
        }
        if (at.child.is_none()) break;
        if (!at.child.is_list()) {
            ask_leaf(at.child.leaf());
        } else {
            for (const Bvh8Child leaf : cells.leaves_of(at.child))
                if (!is_over()) ask_leaf(leaf);
        }
        if (is_over()) break;
        at = waiting.pop(ray.latest_entry());
    }
    traversal.steps += steps;
    ++traversal.box_tests;
    traversal.primitive_tests += triangles;
    if constexpr (test != Bvh8Test::any) locate_nearest(contents, query, leaves);
}

template <Bvh8Test test>
HWY_INLINE bool walk_cells_if_it_fits_floats(const Kd8Cells& cells, const Bvh8Nodes& contents, const Bvh8Query& query,
                                             Bvh8Leaves& leaves, Traversal& traversal) {
    const BoxRay boxes(query.ray, contents, 0);
    if (!boxes.fits_floats) [[unlikely]]
        return false;
    Bvh8Ray ray(query.ray, boxes, query.end);
    walk_cells<test>(cells, contents, ray, query, leaves, traversal);
    return true;
}

bool walk_cells_nearest(const Kd8Cells& cells, const Bvh8Nodes& contents, const Bvh8Query& query, Bvh8Leaves& leaves,
                        Traversal& traversal) {
    return walk_cells_if_it_fits_floats<Bvh8Test::nearest>(cells, contents, query, leaves, traversal);
}

bool walk_cells_any(const Kd8Cells& cells, const Bvh8Nodes& contents, const Bvh8Query& query, Bvh8Leaves& leaves,
                    Traversal& traversal) {
    return walk_cells_if_it_fits_floats<Bvh8Test::any>(cells, contents, query, leaves, traversal);
}

bool walk_cells_nearest_told(const Kd8Cells& cells, const Bvh8Nodes& contents, const Bvh8Query& query,
                             Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_cells_if_it_fits_floats<Bvh8Test::nearest_told>(cells, contents, query, leaves, traversal);
}

CompiledFaults walk_cells_faults() { return faults_of_lanes(); }

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab {

HWY_EXPORT(walk_cells_nearest);
HWY_EXPORT(walk_cells_any);
HWY_EXPORT(walk_cells_nearest_told);
HWY_EXPORT(walk_cells_faults);

Kd8Walks best_kd8_walks() {
    const std::size_t best = best_instruction_set();
    const Kd8Walks walks{HWY_DISPATCH_TABLE(walk_cells_nearest)[best], HWY_DISPATCH_TABLE(walk_cells_any)[best],
                         HWY_DISPATCH_TABLE(walk_cells_nearest_told)[best],
                         HWY_DISPATCH_TABLE(walk_cells_faults)[best]};
    assert(walks.faults() == CompiledFaults{} && "kd8_walk.cpp is compiled with cmake/flags.cmake's flags");
    return walks;
}

}  // namespace raylab
#endif
