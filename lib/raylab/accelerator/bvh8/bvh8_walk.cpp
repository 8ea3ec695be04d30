#include "raylab/accelerator/bvh8/bvh8_walk.h"

#include "raylab/accelerator/bvh8/bvh8_instruction_set.h"
#include "raylab/accelerator/bvh8/bvh8_leaves.h"
#include "raylab/accelerator/bvh8/bvh8_walk_in_doubles.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <new>
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

constexpr bool any_will_do(Bvh8Test test) { return test == Bvh8Test::any || test == Bvh8Test::any_candidate; }

template <Bvh8Test test>
using StackOf = std::conditional_t<any_will_do(test), InOrder, NearestFirst>;

// Walks on from a node or leaf to the next one that is_far(), which is returned, or to the end: none.
template <Bvh8Test test, class IsFar>
HWY_INLINE Bvh8Child walk_on(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Child next, Bvh8Ray& ray,
                             StackOf<test>& waiting, Bvh8Leaves& leaves, Traversal& traversal, const IsFar& is_far) {
    alignas(32) std::array<std::int32_t, bvh8_width> entries;
    const auto* const nodes = reinterpret_cast<const std::byte*>(tree.nodes.data());
    std::uint64_t steps = 0, triangles = 0;
    const auto come_to = [&](Bvh8Child child) HWY_ATTR {
        if constexpr (test == Bvh8Test::nearest_told) leaves.came_to(child);
    };
    const auto is_at_end = [&](Bvh8Child child) HWY_ATTR { return child.is_none() || is_far(child); };
    // From a node on to the next leaf, or to the end. (A loop of its own, so that the ray's numbers stay in registers:
    // where there are 32, that saves 3 to 4 %.)
    const auto leaf_from = [&](Bvh8Child node) HWY_ATTR __attribute__((always_inline)) {
        const BoxLanes boxes(tree, ray.boxes, ray.start, ray.end);
        const std::int32_t latest_entry = ray.latest_entry();
        do {
            come_to(node);
            ++steps;
            const std::size_t offset = node.node_offset();
            const std::uint32_t hit_found = boxes.hit_mask(offset, entries.data());
            node = hit_found == 0
                       ? waiting.pop(latest_entry)
                       : waiting.keep(*reinterpret_cast<const Bvh8Node*>(nodes + offset), entries.data(), hit_found);
        } while (node.is_node() && !is_far(node));
        return node;
    };
    // The way to the first leaf is apart from that to all others, because at each leaf "is the ray prepared for
    // triangles?" was mispredicted for every third ray.
    if (next.is_node()) next = leaf_from(next);
    if (test != Bvh8Test::plain && !is_at_end(next) && tree.triangle_count > 0)
        ray.prepare_for_triangles(query.ray, tree, is_of_candidates(test) ? query.displacement : 0);
    while (!is_at_end(next)) {
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
        next = any_will_do(test) && ray.end < ray.start ? Bvh8Child::none() : waiting.pop(ray.latest_entry());
        if (next.is_node() && !is_far(next)) next = leaf_from(next);
    }
    traversal.steps += steps;
    traversal.box_tests += bvh8_width * steps;
    traversal.primitive_tests += triangles;
    return next;
}

template <Bvh8Test test>
HWY_INLINE bool walk_if_it_fits_floats(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves,
                                       Traversal& traversal) {
    // Constants, where the ray itself is meant, so that they cost nothing.
    const float displacement = is_of_candidates(test) ? query.displacement : 0;
    const BoxRay boxes(query.ray, tree, displacement);
    if (!boxes.fits_floats) [[unlikely]]
        return false;
    if (tree.nodes.empty()) return true;
    Bvh8Ray ray(query.ray, boxes, query.end);
    typename StackOf<test>::Places places;
    StackOf<test> waiting(tree, places);
    walk_on<test>(tree, query, Bvh8Child::node(0), ray, waiting, leaves, traversal,
                  [](Bvh8Child) HWY_ATTR { return false; });
    if constexpr (test == Bvh8Test::nearest || test == Bvh8Test::nearest_told) locate_nearest(tree, query, leaves);
    return true;
}

template <Bvh8Test test>
HWY_INLINE void walk(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    if (!walk_if_it_fits_floats<test>(tree, query, leaves, traversal)) [[unlikely]]
        walk_in_doubles(tree, query, leaves, traversal);
}

// The walk of a ray that takes turns with others.
template <Bvh8Test test>
class WalkInTurns {
public:
    HWY_INLINE WalkInTurns(const Bvh8Nodes& tree, const Bvh8Turns::Asked& asked)
        : asked_(asked),
          boxes_(asked.query.ray, tree, 0),
          ray_(asked.query.ray, boxes_, asked.query.end),
          waiting_(tree, places_) {}
    WalkInTurns(const WalkInTurns&) = delete;  // its parts refer to each other
    WalkInTurns& operator=(const WalkInTurns&) = delete;

    HWY_INLINE bool fits_floats() const { return boxes_.fits_floats; }

    // Walks on to what has been prefetched but may still be on its way, or to the end: then false.
    HWY_INLINE bool go_on(const Bvh8Nodes& tree, std::size_t near_bytes, Traversal& traversal) {
        const auto is_far = [=, waited_for = next_](Bvh8Child child) HWY_ATTR {
            return child.offset() >= near_bytes && child.offset() != waited_for.offset();
        };
        next_ = walk_on<test>(tree, asked_.query, next_, ray_, waiting_, asked_.leaves, traversal, is_far);
        if (!next_.is_none()) return true;
        if constexpr (test == Bvh8Test::nearest) locate_nearest(tree, asked_.query, asked_.leaves);
        return false;
    }

private:
    const Bvh8Turns::Asked& asked_;
    BoxRay boxes_;
    Bvh8Ray ray_;
    StackOf<test> waiting_;
    Bvh8Child next_ = Bvh8Child::node(0);
    typename StackOf<test>::Places places_;
};

template <Bvh8Test test>
HWY_INLINE void walk_in_turns(const Bvh8Nodes& tree, std::size_t near_bytes, Bvh8Turns& turns, Traversal& traversal) {
    using Walk = WalkInTurns<test>;
    // (Not optional walks, whose functions are compiled for no instruction set in particular.)
    struct Place {
        alignas(Walk) std::array<std::byte, sizeof(Walk)> memory;
        Walk* walk;
    };
    std::array<Place, Bvh8Turns::under_way> places;
    // The next ray's walk, at a place, if there is one.
    const auto begun = [&](std::size_t i) HWY_ATTR {
        while (const Bvh8Turns::Asked* const asked = turns.next(i)) {
            auto* const walk = new (places[i].memory.data()) Walk(tree, *asked);
            if (walk->fits_floats()) return walk;
            turns.exceeds_floats(i);
        }
        return static_cast<Walk*>(nullptr);
    };
    for (std::size_t i = 0; i < places.size(); ++i) places[i].walk = begun(i);
    for (bool are_under_way = true; are_under_way;) {
        are_under_way = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!places[i].walk) continue;
            are_under_way = true;
            if (places[i].walk->go_on(tree, near_bytes, traversal)) continue;
            turns.ended(i);
            places[i].walk = begun(i);
        }
    }
}

// Whole answers, so that what the exact tests are given with each ray is compiled into the walk: 30 to 40 instructions
// of a ray fewer than where they called it.
std::optional<Hit> closest(const Bvh8Contents& contents, const Ray& ray, Traversal& traversal) {
    NearestLeaves leaves(contents, ray, traversal);
    walk<Bvh8Test::nearest>(contents.tree(), {ray, leaves.end(), contents.number_left_by(ray)}, leaves, traversal);
    return leaves.hit();
}

bool occluded(const Bvh8Contents& contents, const Ray& ray, Traversal& traversal) {
    AnyLeaves leaves(contents, ray, traversal);
    if (leaves.is_hit_at_once()) return true;
    walk<Bvh8Test::any>(contents.tree(), {ray, leaves.end(), contents.number_left_by(ray)}, leaves, traversal);
    return leaves.is_hit();
}

std::optional<Hit> closest_in_floats(const Bvh8Contents& contents, const Ray& ray, Traversal& traversal) {
    NearestLeaves leaves(contents, ray, traversal);
    walk_if_it_fits_floats<Bvh8Test::plain>(contents.tree(), {ray, ray.range.max, contents.number_left_by(ray)}, leaves,
                                            traversal);
    return leaves.hit();
}

bool walk_nearest_told(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::nearest_told>(tree, query, leaves, traversal);
}

bool walk_candidates(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::candidates>(tree, query, leaves, traversal);
}

bool walk_any_candidate(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) {
    return walk_if_it_fits_floats<Bvh8Test::any_candidate>(tree, query, leaves, traversal);
}

void walk_nearest_in_turns(const Bvh8Nodes& tree, std::size_t near_bytes, Bvh8Turns& turns, Traversal& traversal) {
    walk_in_turns<Bvh8Test::nearest>(tree, near_bytes, turns, traversal);
}

void walk_any_in_turns(const Bvh8Nodes& tree, std::size_t near_bytes, Bvh8Turns& turns, Traversal& traversal) {
    walk_in_turns<Bvh8Test::any>(tree, near_bytes, turns, traversal);
}

CompiledFaults walk_faults() { return faults_of_lanes(); }

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab {

HWY_EXPORT(closest);
HWY_EXPORT(occluded);
HWY_EXPORT(closest_in_floats);
HWY_EXPORT(walk_nearest_told);
HWY_EXPORT(walk_candidates);
HWY_EXPORT(walk_any_candidate);
HWY_EXPORT(walk_nearest_in_turns);
HWY_EXPORT(walk_any_in_turns);
HWY_EXPORT(walk_faults);

Bvh8Walks best_bvh8_walks() {
    const std::size_t best = best_instruction_set();
    const Bvh8Walks walks{HWY_DISPATCH_TABLE(closest)[best],
                          HWY_DISPATCH_TABLE(occluded)[best],
                          HWY_DISPATCH_TABLE(closest_in_floats)[best],
                          HWY_DISPATCH_TABLE(walk_nearest_told)[best],
                          HWY_DISPATCH_TABLE(walk_candidates)[best],
                          HWY_DISPATCH_TABLE(walk_any_candidate)[best],
                          HWY_DISPATCH_TABLE(walk_nearest_in_turns)[best],
                          HWY_DISPATCH_TABLE(walk_any_in_turns)[best],
                          HWY_DISPATCH_TABLE(walk_faults)[best]};
    assert(walks.faults() == CompiledFaults{} && "bvh8_walk.cpp is compiled with cmake/flags.cmake's flags");
    return walks;
}

}  // namespace raylab
#endif
