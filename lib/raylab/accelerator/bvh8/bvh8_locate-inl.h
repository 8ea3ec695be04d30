// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_LOCATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_LOCATE_INL_H
#undef RAYLAB_BVH8_LOCATE_INL_H
#else
#define RAYLAB_BVH8_LOCATE_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_vertices-inl.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/four_floats.h"

#include <hwy/highway.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// Three numbers as doubles and an unused fourth, in the vector types of GCC and Clang, which use whatever registers
// the instruction set has. (std::bit_cast cannot be used: it is compiled for the baseline instruction set, and Clang
// refuses to call it with these types.)
using FourDoubles [[gnu::vector_size(32)]] = double;
using FourDoublesBits [[gnu::vector_size(32)]] = std::int64_t;

HWY_INLINE FourDoubles in_doubles(FourFloats x) {
#if HWY_TARGET <= HWY_AVX2
    // One instruction; GCC would use five for the conversion.
    using Parts = hn::CappedTag<float, 4>;
    return reinterpret_cast<FourDoubles>(
        hn::PromoteTo(hn::CappedTag<double, 4>(), std::bit_cast<hn::Vec<Parts>>(x)).raw);
#else
    return __builtin_convertvector(x, FourDoubles);
#endif
}
HWY_INLINE FourDoubles size(FourDoubles x) {
    return reinterpret_cast<FourDoubles>(reinterpret_cast<FourDoublesBits>(x) & std::int64_t{0x7fffffffffffffff});
}
HWY_INLINE FourDoubles larger(FourDoubles p, FourDoubles q) {
#if HWY_TARGET <= HWY_AVX2
    using Four = hn::Vec<hn::CappedTag<double, 4>>;  // one instruction again
    return reinterpret_cast<FourDoubles>(
        hn::Max(Four{reinterpret_cast<__m256d>(p)}, Four{reinterpret_cast<__m256d>(q)}).raw);
#else
    return p > q ? p : q;
#endif
}

// A point, or a direction, for each of the corners a, b, c of a triangle.
struct OfCorners {
    FourDoubles x, y, z;

    template <class F>
    HWY_INLINE OfCorners with(const F& f) const {
        return {f(x), f(y), f(z)};
    }
    HWY_INLINE OfCorners next() const {  // those of b, c, a
        return with([](FourDoubles v) HWY_ATTR { return __builtin_shufflevector(v, v, 1, 2, 0, 3); });
    }
    HWY_INLINE OfCorners last() const {  // those of c, a, b
        return with([](FourDoubles v) HWY_ATTR { return __builtin_shufflevector(v, v, 2, 0, 1, 3); });
    }
};

// The same for all corners: three floats of the ray, which another of its members follows.
HWY_INLINE OfCorners same_for_all(const Ray& ray, std::size_t offset) {
    FourFloats read;
    std::memcpy(&read, reinterpret_cast<const std::byte*>(&ray) + offset, sizeof read);
    const FourDoubles v = in_doubles(read);
    return {__builtin_shufflevector(v, v, 0, 0, 0, 0), __builtin_shufflevector(v, v, 1, 1, 1, 1),
            __builtin_shufflevector(v, v, 2, 2, 2, 2)};
}

#include "raylab/geometry/filter/triple_product-inl.h"

// The hit of a triangle that the ray is known to hit inside its range, in the very bits of intersect(), and whether t
// is accurate.
//
// The formula is triangle_filter.h's, for three edges at once. Wherever floats decide that there is a hit, decide()
// there decides so, too: Bvh8Ray's error_linear has .19 E^2 to spare, twelve times decide()'s bound of an edge.
//
// Lanes pay: without this function, tracing 20 000 rays to the bunny takes 9.8 % more instructions.
HWY_INLINE Bvh8Place place_of_hit(const Ray& ray, const Bvh8Vertices& vertices, std::size_t place) {
    const CornersOfOne corners = corners_of(vertices, place);
    const OfCorners origin = same_for_all(ray, offsetof(Ray, origin)),
                    direction = same_for_all(ray, offsetof(Ray, direction));
    const OfCorners at{in_doubles(corners.x) - origin.x, in_doubles(corners.y) - origin.y,
                       in_doubles(corners.z) - origin.z},
        next = at.next(), last = at.last();
    const FourDoubles edges = triple_product(direction, next, last), own = triple_product(at, next, last);
    const double determinant = edges[0] + edges[1] + edges[2];
    const FourDoubles found = __builtin_shufflevector(own, edges, 0, 5, 6, 7) / determinant;

    // With u the unit roundoff, m the largest coordinates, m_xyz their product and e = |d_x| m_y m_z + ..., decide()
    // bounds the error of t by (54 u m_xyz + |t| (48 u e + 3 u determinant)) / (determinant - 48 u e), and some u |t|
    // more. The ray hits the triangle at t d, whose coordinates are no larger than m: so |t| e is at most 3 m_xyz, and
    // the error is 198 u m_xyz / determinant but for a hundredth of t_accuracy. The triangle's own volume is t
    // determinant.
    const auto largest = [](FourDoubles p, FourDoubles q, FourDoubles r)
                             HWY_ATTR { return larger(larger(size(p), size(q)), size(r)); };
    const FourDoubles m_xyz =
        largest(at.x, next.x, last.x) * largest(at.y, next.y, last.y) * largest(at.z, next.z, last.z);
    constexpr double needed = 198 * unit_roundoff<double> / (t_accuracy * 15 / 16);
    return {found[0], found[1], found[2], m_xyz[0] * needed < std::abs(double{own[0]})};
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
