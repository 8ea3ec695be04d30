// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_LEAF_INL_H
#undef RAYLAB_BVH8_LEAF_INL_H
#else
#define RAYLAB_BVH8_LEAF_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_locate-inl.h"
#include "raylab/accelerator/bvh8/bvh8_triangles-inl.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/geometry/flush_triangles.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// The question that is asked about a leaf's triangles.
enum class Bvh8Test { nearest, nearest_told, any, candidates, any_candidate, plain };

constexpr bool is_of_candidates(Bvh8Test test) {
    return test == Bvh8Test::candidates || test == Bvh8Test::any_candidate;
}

// Whether a triangle is the one of the hit that is kept: one that was split is met again in another leaf, and ends the
// ray exactly where it hits.
HWY_INLINE bool is_nearest(const Bvh8Nodes& tree, Bvh8Child leaf, std::size_t place, const Bvh8Leaves& leaves) {
    return leaves.nearest && tree.number(leaves.nearest->leaf, leaves.nearest->place) == tree.number(leaf, place);
}

// Settles a tie: where a triangle that the ray surely crosses is flush with that of the hit that is kept, as a roof
// with its cornice, both are hit at the same t, and the one of the lower number is kept. False: they are not flush. (No
// exact test is as quick. Inlined, it would cost every ray 1 % of its instructions.)
inline HWY_NOINLINE bool settle_tie(const Bvh8Nodes& tree, Bvh8Child leaf, std::size_t place, Bvh8Leaves& leaves) {
    if (!leaves.nearest) return false;
    Bvh8Hit& last = *leaves.nearest;
    if (!are_flush(tree.triangle(last.leaf, last.place), tree.triangle(leaf, place))) return false;
    if (tree.number(leaf, place) < tree.number(last.leaf, last.place)) {
        last.leaf = leaf;
        last.place = static_cast<std::uint32_t>(place);
    }
    return true;
}

// Keeps the nearer hit. Where floats cannot tell which one that is, both are passed on to be tested exactly, and none
// is kept.
HWY_INLINE void keep_nearest(const Bvh8Nodes& tree, const Bvh8Hit& next, Bvh8Ray& ray, Bvh8Leaves& leaves) {
    if (!leaves.nearest || next.latest < leaves.nearest->soonest) {
        leaves.nearest = next;
        ray.end = next.latest;  // sooner than it was, but where exact tests of this leaf's triangles have ended the ray
    } else if (next.soonest <= leaves.nearest->latest) {
        if (is_nearest(tree, next.leaf, next.place, leaves)) return;
        if (settle_tie(tree, next.leaf, next.place, leaves)) return;
        const Bvh8Hit last = *leaves.nearest;
        leaves.nearest.reset();
        ray.end_by(std::min(leaves.uncertain(last.leaf, last.place), leaves.uncertain(next.leaf, next.place)));
    }
}

// Computes the hit that the traversal has kept, in doubles, once for each ray.
HWY_INLINE void locate_nearest(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves) {
    if (!leaves.nearest) return;
    leaves.at = place_of_hit(query.ray, tree.vertices(leaves.nearest->leaf), leaves.nearest->place);
}

// A mask of those of a leaf's triangles, from the i-th of `count` on, that have this number. (Where fewer than `lanes`
// are left, they are read together with what stands in front of them: nothing behind the leaf is read.)
HWY_INLINE std::uint32_t places_of_number(std::uint32_t number, const Bvh8Vertices& vertices, std::size_t i,
                                          std::size_t count) {
    const std::size_t before = i + lanes > count ? i + lanes - count : 0;
    const auto numbers = hn::BitCast(places_tag, hn::LoadU(lanes_tag, vertices.numbers() + i - before));
    const auto same = hn::Eq(numbers, hn::Set(places_tag, static_cast<std::int32_t>(number)));
    return bits(hn::RebindMask(lanes_tag, same)) >> before;
}

// The lowest bit that is set.
HWY_INLINE std::uint32_t lowest(std::uint32_t mask) { return mask & (0 - mask); }

// Tests the triangles of a leaf: first in floats; those that floats leave open are passed on to be tested exactly.
template <Bvh8Test test>
HWY_INLINE void ask(const Bvh8Nodes& tree, Bvh8Ray& ray, const Bvh8Query& query, Bvh8Child leaf, Bvh8Leaves& leaves) {
    const std::size_t count = leaf.count();
    const Bvh8Vertices vertices = tree.vertices(leaf);
    const Tables sheared = sheared_vertices(ray, vertices);
    for (std::size_t i = 0; i < count; i += lanes) {
        const Corners corners(vertices, i);
        const Areas areas(ray, sheared, corners);
        std::uint32_t open = areas.open(count - i);
        if (open == 0) continue;
        const auto place_of = [&](std::uint32_t which)
                                  HWY_ATTR { return i + static_cast<std::size_t>(std::countr_zero(which)); };
        if constexpr (is_of_candidates(test)) {
            std::uint32_t sure = 0;
            if constexpr (test == Bvh8Test::any_candidate) {
                // Hit by each ray at a displacement d, at a t(d) of the range, whose end was rounded up. The exact
                // ray's d changes with t: but while t runs through the range t(d) stays inside of it, so once they are
                // equal.
                const float end = ray.end * (1 - 4 * unit);
                sure = open & Sure(areas, ray, sheared, corners).hit_before(end, ray);
            }
            for (std::uint32_t left = open; left != 0; left &= left - 1) {
                const bool is_sure = (sure & lowest(left)) != 0;
                ray.end_by(is_sure ? leaves.hit_found(leaf, place_of(left)) : leaves.uncertain(leaf, place_of(left)));
            }
            continue;
        }
        // The triangle that the ray leaves is always open, and mostly alone.
        if (query.leaving != Bvh8Query::leaves_none) {
            open &= ~places_of_number(query.leaving, vertices, i, count);
            if (open == 0) continue;
        }
        const Sure sure(areas, ray, sheared, corners);
        if (const std::uint32_t front_only = corners.front_only(); front_only != 0)
            open &= ~(front_only & sure.crossed_from_behind(areas, ray));
        const std::uint32_t hit = open & sure.hit(ray);
        std::uint32_t uncertain = open & ~hit & ~sure.out_of_range(ray);
        if (hit != 0) {
            const Sure::Bounds t = sure.bounds();
            // Places are counted in those that are open, which is known sooner than what is hit of them: the bounds are
            // then read as soon as they are stored.
            for (std::uint32_t left = open; left != 0; left &= left - 1) {
                const std::size_t place = place_of(left);
                if ((hit & lowest(left)) == 0) continue;
                if constexpr (test == Bvh8Test::any) return ray.end_by(leaves.hit_found(leaf, place));
                keep_nearest(tree, {leaf, static_cast<std::uint32_t>(place), t.soonest[place - i], t.latest[place - i]},
                             ray, leaves);
            }
        }
        for (; uncertain != 0; uncertain &= uncertain - 1) {
            const std::size_t place = place_of(uncertain);
            if (is_nearest(tree, leaf, place, leaves)) continue;
            const bool is_crossed = (sure.crossed() >> (place - i) & 1) != 0;
            if (is_crossed && settle_tie(tree, leaf, place, leaves)) continue;
            ray.end_by(leaves.uncertain(leaf, place));
        }
    }
}

// Pluecker's test from the ray's origin, in floats, with t and the weights: keeps a leaf's nearest hit, if it comes
// before the end.
HWY_INLINE void ask_plainly(const Bvh8Nodes& tree, Bvh8Ray& ray, const Ray& of, Bvh8Child leaf, Bvh8Leaves& leaves) {
    const std::size_t count = leaf.count();
    const Bvh8Vertices vertices = tree.vertices(leaf);
    const Tables seen(vertices, {0, 1, 2}, [&](Floats x, Floats y, Floats z) HWY_ATTR {
        return Moved{hn::Sub(x, all(of.origin.x)), hn::Sub(y, all(of.origin.y)), hn::Sub(z, all(of.origin.z))};
    });
    for (std::size_t i = 0; i < count; i += lanes) {
        const Corners corners(vertices, i);
        const Floats ax = corners.of<0>(seen.x), ay = corners.of<0>(seen.y), az = corners.of<0>(seen.z);
        const Floats bx = corners.of<1>(seen.x), by = corners.of<1>(seen.y), bz = corners.of<1>(seen.z);
        const Floats cx = corners.of<2>(seen.x), cy = corners.of<2>(seen.y), cz = corners.of<2>(seen.z);
        const Floats dx = all(of.direction.x), dy = all(of.direction.y), dz = all(of.direction.z);
        const auto area = [](Floats p, Floats q, Floats r, Floats s)
                              HWY_ATTR { return hn::MulSub(p, q, hn::Mul(r, s)); };
        const auto dot = [](Floats x, Floats y, Floats z, Floats p, Floats q, Floats r)
                             HWY_ATTR { return hn::MulAdd(z, r, hn::MulAdd(y, q, hn::Mul(x, p))); };
        const Floats nx = area(by, cz, bz, cy), ny = area(bz, cx, bx, cz), nz = area(bx, cy, by, cx);
        const Floats u = dot(nx, ny, nz, dx, dy, dz);
        const Floats v = dot(area(cy, az, cz, ay), area(cz, ax, cx, az), area(cx, ay, cy, ax), dx, dy, dz);
        const Floats w = dot(area(ay, bz, az, by), area(az, bx, ax, bz), area(ax, by, ay, bx), dx, dy, dz);
        const Floats smallest = hn::Min(hn::Min(u, v), w), largest = hn::Max(hn::Max(u, v), w),
                     zero = hn::Zero(lanes_tag);
        const Mask inside = hn::Or(hn::Ge(smallest, zero), hn::Le(largest, zero));
        std::uint32_t candidates = bits(inside) & ((1u << (count - i)) - 1);
        candidates &= ~(corners.front_only() & bits(hn::Gt(largest, zero)));
        if (candidates == 0) continue;
        const Floats inverse = hn::Div(all(1), hn::Add(hn::Add(u, v), w));
        alignas(32) std::array<float, bvh8_width> t, of_b, of_c;
        hn::Store(hn::Mul(dot(nx, ny, nz, ax, ay, az), inverse), lanes_tag, t.data());
        hn::Store(hn::Mul(v, inverse), lanes_tag, of_b.data());
        hn::Store(hn::Mul(w, inverse), lanes_tag, of_c.data());
        for (; candidates != 0; candidates &= candidates - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(candidates));
            if (!(t[lane] >= ray.start && t[lane] <= ray.end)) continue;
            ray.end = t[lane];
            leaves.nearest = {leaf, static_cast<std::uint32_t>(i + lane), t[lane], t[lane]};
            leaves.at = {t[lane], of_b[lane], of_c[lane], true};
        }
    }
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
