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
// The largest of their sizes.
HWY_INLINE FourDoubles largest_size(FourDoubles p, FourDoubles q, FourDoubles r) {
#if HWY_TARGET <= HWY_AVX2
    using Four = hn::Vec<hn::CappedTag<double, 4>>;
    const auto wide = [](FourDoubles x) HWY_ATTR { return reinterpret_cast<__m256d>(x); };
#endif
#if HWY_TARGET <= HWY_AVX3  // Two instructions; Highway has none for it.
    constexpr int larger_without_sign = 0b1011;
    return reinterpret_cast<FourDoubles>(
        _mm256_range_pd(_mm256_range_pd(wide(p), wide(q), larger_without_sign), wide(r), larger_without_sign));
#elif HWY_TARGET <= HWY_AVX2  // GCC would compare and choose.
    return reinterpret_cast<FourDoubles>(
        hn::Max(hn::Max(hn::Abs(Four{wide(p)}), hn::Abs(Four{wide(q)})), hn::Abs(Four{wide(r)})).raw);
#else
    const auto size = [](FourDoubles x) HWY_ATTR {
        return reinterpret_cast<FourDoubles>(reinterpret_cast<FourDoublesBits>(x) & std::int64_t{0x7fffffffffffffff});
    };
    const auto larger = [](FourDoubles x, FourDoubles y) HWY_ATTR { return x > y ? x : y; };
    return larger(larger(size(p), size(q)), size(r));
#endif
}

// A point, or a direction, for each of the corners b, c, a, b of a triangle, in this order.
struct OfCorners {
    FourDoubles x, y, z;

    template <class F>
    HWY_INLINE OfCorners with(const F& f) const {
        return {f(x), f(y), f(z)};
    }
    // Those of c, a, b, c.
    HWY_INLINE OfCorners next() const {
        return with([](FourDoubles v) HWY_ATTR { return __builtin_shufflevector(v, v, 1, 2, 0, 1); });
    }
    // The second one's comes first; the others are not used. (It stays in its half of the register, as x86's
    // instructions like it: a cycle instead of three.)
    HWY_INLINE OfCorners second() const {
        return with([](FourDoubles v) HWY_ATTR { return __builtin_shufflevector(v, v, 1, 0, 3, 2); });
    }
    // These, but for the first corner that of others.
    HWY_INLINE OfCorners with_first(const OfCorners& of) const {
        const auto blended = [](FourDoubles first, FourDoubles others)
                                 HWY_ATTR { return __builtin_shufflevector(first, others, 0, 5, 6, 7); };
        return {blended(of.x, x), blended(of.y, y), blended(of.z, z)};
    }
};

HWY_INLINE OfCorners same_for_all(const Vec3f& v) {
    const auto same = [](const float& x) HWY_ATTR {
#if HWY_TARGET <= HWY_AVX3  // (GCC would need two instructions, of which one moves numbers between the halves.)
        FourDoubles found;
        asm("vcvtps2pd %1%{1to4%}, %0" : "=v"(found) : "m"(x));
        return found;
#else
        return in_doubles(FourFloats{x, x, x, x});
#endif
    };
    return {same(v.x), same(v.y), same(v.z)};
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
    const OfCorners origin = same_for_all(ray.origin), direction = same_for_all(ray.direction);
    const OfCorners at{in_doubles(corners.x) - origin.x, in_doubles(corners.y) - origin.y,
                       in_doubles(corners.z) - origin.z},
        next = at.next(), a = next.second();
    // Of a, b and c, which is t determinant; and of the direction and each edge: ca, ab, bc.
    const FourDoubles volumes = triple_product(direction.with_first(a), at, next);
    const double determinant = volumes[3] + volumes[1] + volumes[2];
    const FourDoubles found = volumes / determinant;

    // With u the unit roundoff, m the largest coordinates, m_xyz their product and e = |d_x| m_y m_z + ..., decide()
    // bounds the error of t by (54 u m_xyz + |t| (48 u e + 3 u determinant)) / (determinant - 48 u e), and some u |t|
    // more. The ray hits the triangle at t d, whose coordinates are no larger than m: so |t| e is at most 3 m_xyz, and
    // the error is 198 u m_xyz / determinant but for a hundredth of t_accuracy.
    const FourDoubles m_xyz =
        largest_size(at.x, next.x, a.x) * largest_size(at.y, next.y, a.y) * largest_size(at.z, next.z, a.z);
    constexpr double needed = 198 * unit_roundoff<double> / (t_accuracy * 15 / 16);
    return {found[0], found[1], found[2], m_xyz[0] * needed < std::abs(double{volumes[0]})};
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
