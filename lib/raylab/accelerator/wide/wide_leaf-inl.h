// Compiled once for every instruction set (see wide_walk.cpp): a guard that opens again for the next.
#if defined(RAYLAB_WIDE_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_WIDE_LEAF_INL_H
#undef RAYLAB_WIDE_LEAF_INL_H
#else
#define RAYLAB_WIDE_LEAF_INL_H
#endif

#include "raylab/accelerator/wide/wide_triangles-inl.h"
#include "raylab/accelerator/wide/wide_walk.h"
#include "raylab/geometry/triangle_filter.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <variant>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// What is asked about a leaf's triangles.
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

// Asks about the triangles of a leaf that floats leave open; where any hit will do, the sure ones come first. Returns a t beyond
// which nothing matters.
template <WideTest test>
HWY_INLINE double ask(const WideNodes& tree, const WideRay& ray, const WideQuery& query, WideChild leaf, WideLeaves& leaves) {
    double end = query.end;
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

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
