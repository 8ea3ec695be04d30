#include "raylab/accelerator/wide/wide_walk.h"

#include "raylab/geometry/triangle_filter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>

// Compiled once for every instruction set named by Highway; which one runs is decided where the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raylab/accelerator/wide/wide_walk.cpp"
#include <hwy/foreach_target.h>

#include "raylab/accelerator/wide/wide_lanes-inl.h"
#include "raylab/accelerator/wide/wide_ray-inl.h"
#include "raylab/accelerator/wide/wide_triangles-inl.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// The ray as registers hold it while it meets boxes.
struct BoxLanes {
    std::array<std::size_t, 3> near_row, far_row;
    Floats near_origin[3], far_origin[3], near_inverse[3], far_inverse[3], start;

    HWY_INLINE explicit BoxLanes(const WideRay& ray) : start(all(ray.start)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            near_row[axis] = ray.near_row[axis];
            far_row[axis] = ray.far_row[axis];
            near_origin[axis] = all(ray.near_origin[axis]);
            far_origin[axis] = all(ray.far_origin[axis]);
            near_inverse[axis] = all(ray.near_inverse[axis]);
            far_inverse[axis] = all(ray.far_inverse[axis]);
        }
    }

    // Which of a node's boxes the ray meets, and where it enters each.
    HWY_INLINE std::uint32_t meet(const WideNode& node, float end, float* HWY_RESTRICT entries) const {
        const float* rows = node.planes[0].data();
        std::uint32_t met = 0;
        for (std::size_t i = 0; i < wide; i += lanes) {
            const auto in = [&](std::size_t axis) HWY_ATTR {
                return hn::Mul(hn::Sub(hn::Load(lanes_tag, rows + near_row[axis] + i), near_origin[axis]), near_inverse[axis]);
            };
            const auto out = [&](std::size_t axis) HWY_ATTR {
                return hn::Mul(hn::Sub(hn::Load(lanes_tag, rows + far_row[axis] + i), far_origin[axis]), far_inverse[axis]);
            };
            const Floats entry = hn::Max(hn::Max(in(0), in(1)), hn::Max(in(2), start));
            const Floats exit = hn::Min(hn::Min(out(0), out(1)), hn::Min(out(2), all(end)));
            hn::Store(entry, lanes_tag, entries + i);
            met |= bits(hn::Le(entry, exit)) << i;
        }
        return met;
    }
};

// A child and where the ray enters it, in one number, the less the nearer: floats that are not negative are ordered as their
// bits are. So a few of them are sorted without a branch that could be foreseen wrongly.
class Waiting {
public:
    Waiting() = default;
    HWY_INLINE Waiting(const WideNode& node, const float* entries, std::uint32_t met) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        key_ = std::uint64_t{std::bit_cast<std::uint32_t>(entries[i])} << 32 | std::bit_cast<std::uint32_t>(node.children[i]);
    }
    HWY_INLINE WideChild child() const { return std::bit_cast<WideChild>(static_cast<std::uint32_t>(key_)); }
    HWY_INLINE float entry() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
    friend HWY_INLINE bool operator<(Waiting a, Waiting b) { return a.key_ < b.key_; }

    // The nearer of the two into a.
    static HWY_INLINE void put_in_order(Waiting& a, Waiting& b) {
        const std::uint64_t swapped = (a.key_ ^ b.key_) & (std::uint64_t{0} - std::uint64_t{b < a});
        a.key_ ^= swapped;
        b.key_ ^= swapped;
    }

private:
    std::uint64_t key_;
};

class Stack {
public:
    using Places = std::array<Waiting, WideNodes::max_depth * (wide - 1) + 1>;

    HWY_INLINE Stack(const WideNodes& tree, Places& places)
        : starts_{reinterpret_cast<const char*>(tree.nodes.data()), reinterpret_cast<const char*>(tree.corners.data())},
          bottom_(places.data()),
          top_(bottom_) {}
    HWY_INLINE bool is_empty() const { return top_ == bottom_; }
    HWY_INLINE Waiting pop() { return *--top_; }

    // Keeps the children that the ray meets, at least one, farthest first, and returns the nearest.
    HWY_INLINE WideChild keep(const WideNode& node, const float* entries, std::uint32_t met) {
        Waiting a(node, entries, met);
        if ((met &= met - 1) == 0) return a.child();
        Waiting b(node, entries, met);
        Waiting::put_in_order(a, b);
        if ((met &= met - 1) == 0) {
            push(b);
            return a.child();
        }
        Waiting c(node, entries, met);
        Waiting::put_in_order(b, c);
        Waiting::put_in_order(a, b);
        if ((met &= met - 1) == 0) {
            push(c);
            push(b);
            return a.child();
        }
        Waiting* const first = top_;
        push(c);
        push(b);
        push(a);
        for (; met != 0; met &= met - 1) insert(first, Waiting(node, entries, met));
        return pop().child();
    }

private:
    HWY_INLINE void push(Waiting one) {
        prefetch(one.child());
        *top_++ = one;
    }

    HWY_INLINE void insert(Waiting* first, Waiting one) {
        prefetch(one.child());
        Waiting* at = top_++;
        for (; at != first && *(at - 1) < one; --at) *at = *(at - 1);
        *at = one;
    }

    // Asks memory for what a child is, while another one is looked at. (Without a branch: nodes and leaves take turns.)
    HWY_INLINE void prefetch(WideChild child) const {
        constexpr std::array<std::size_t, 2> sizes{sizeof(WideNode), 9 * sizeof(float)};
        const std::size_t leaf = child.is_node() ? 0 : 1;
        const char* at = starts_[leaf] + sizes[leaf] * child.first();
        for (std::size_t line = 0; line < 4; ++line) hwy::Prefetch(at + 64 * line);
    }

    std::array<const char*, 2> starts_;
    Waiting *bottom_, *top_;
};

enum class WideTest { nearest, nearest_told, any, plain };

// Rounded outward: an error has a quarter to spare.
HWY_INLINE double upper(const Candidate& at) { return at.t + 1.25 * at.t_error; }
HWY_INLINE double lower(const Candidate& at) { return at.t - 1.25 * at.t_error; }

// Keeps the nearer hit; where two are too close together to tell, both are told the leaves, which know more. Returns where
// hits stop to matter.
HWY_INLINE double keep_nearest(const WideHit& next, WideLeaves& leaves) {
    if (!leaves.nearest || upper(next.at) < lower(leaves.nearest->at)) {
        leaves.nearest = next;
        return upper(next.at);
    }
    if (lower(next.at) > upper(leaves.nearest->at)) return upper(leaves.nearest->at);
    const WideHit last = *leaves.nearest;
    leaves.nearest.reset();
    return std::min(leaves.met(last), leaves.met(next));
}

HWY_INLINE triangle_filter::Filter filter_of(const Ray& ray, const float* rows, WideChild leaf, std::size_t place) {
    const auto corner = [&](std::size_t vertex) HWY_ATTR {
        const auto row = [&](std::size_t axis) HWY_ATTR { return rows[(3 * vertex + axis) * leaf.count() + place]; };
        return Vec3f(row(0), row(1), row(2));
    };
    return filter(ray, triangle_filter::corners(ray, {corner(0), corner(1), corner(2)}));
}

// In doubles, where floats leave a triangle open.
HWY_INLINE double look_closely(const WideQuery& query, const float* rows, WideChild leaf, std::size_t place, double end,
                               WideLeaves& leaves) {
    using namespace triangle_filter;
    const Decision decision = decide(filter_of(query.ray, rows, leaf, place), query.ray.range, Sides::both);
    if (const auto* at = std::get_if<Candidate>(&decision)) return leaves.met({leaf, place, *at});
    return std::holds_alternative<Miss>(decision) ? end : leaves.doubtful(leaf, place);
}

// Asks about the triangles of a leaf that floats leave open; where any hit will do, the sure ones come first.
template <WideTest test>
HWY_INLINE double ask(const WideNodes& tree, const WideRay& ray, const WideQuery& query, WideChild leaf, double end, WideLeaves& leaves) {
    const std::size_t count = leaf.count();
    const float* rows = tree.corners.data() + 9 * leaf.first();
    for (std::size_t i = 0; i < count; i += lanes) {
        const Areas areas(ray, rows + i, count);
        std::uint32_t open = areas.open() & ((1u << (count - i)) - 1);
        if (open == 0) continue;
        const Areas::Sure sure = areas.sure(ray);
        open &= ~sure.out_of_range;
        const auto next_place = [&](std::uint32_t of) HWY_ATTR { return i + static_cast<std::size_t>(std::countr_zero(of)); };
        if constexpr (test == WideTest::any) {
            for (std::uint32_t hit = open & sure.hit; hit != 0; hit &= hit - 1)
                if (const std::size_t place = next_place(hit); tree.triangles[leaf.first() + place] != ray.leaving)
                    return leaves.met(leaf, place);
        }
        for (; open != 0; open &= open - 1) {
            const std::size_t place = next_place(open);
            if (tree.triangles[leaf.first() + place] == ray.leaving) continue;
            if (test != WideTest::any && (open & -open & sure.accurate) != 0)
                end = std::min(end, keep_nearest({leaf, place, known_hit(filter_of(query.ray, rows, leaf, place))}, leaves));
            else
                end = std::min(end, look_closely(query, rows, leaf, place, end, leaves));
        }
    }
    return end;
}

template <WideTest test>
HWY_INLINE void walk_with(const WideNodes& tree, WideRay& ray, const WideQuery& query, WideLeaves& leaves,
                                            Traversal& traversal) {
    constexpr double no_change = std::numeric_limits<double>::infinity();
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
            if (const std::uint32_t met = boxes.meet(node, ray.end, entries.data())) {
                next = stack.keep(node, entries.data(), met);
                continue;
            }
        } else if (next.kind() == WideChild::Kind::triangles) {
            triangles += next.count();
            if constexpr (test == WideTest::plain) {
                std::size_t place = 0;
                if (plain_hit(ray, tree.corners.data() + 9 * next.first(), next.count(), place)) 
                    leaves.nearest = WideHit{next, place, {.t = ray.end, .t_error = 0}};
            } else {
                const double end = ask<test>(tree, ray, query, next, no_change, leaves);
                if (end != no_change) ray.set_end(end);
            }
        } else {
            ray.set_end(leaves.others(next));
        }
        Waiting waiting;
        do {
            if (stack.is_empty()) {
                traversal.steps += steps;
                traversal.box_tests += wide * steps;
                traversal.primitive_tests += triangles;
                return;
            }
            waiting = stack.pop();
        } while (!(waiting.entry() <= ray.end));
        next = waiting.child();
    }
}

template <WideTest test>
HWY_INLINE bool walk_if_tame(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal) {
    WideRay ray(query.ray, tree, query.end, query.leaving);
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

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab {

HWY_EXPORT(walk_nearest);
HWY_EXPORT(walk_any);
HWY_EXPORT(walk_nearest_told);
HWY_EXPORT(walk_plain);

WideWalks best_wide_walks() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const std::size_t best = hwy::GetChosenTarget().GetIndex();
    return {HWY_DISPATCH_TABLE(walk_nearest)[best], HWY_DISPATCH_TABLE(walk_any)[best], HWY_DISPATCH_TABLE(walk_nearest_told)[best],
            HWY_DISPATCH_TABLE(walk_plain)[best]};
}

}  // namespace raylab
#endif
