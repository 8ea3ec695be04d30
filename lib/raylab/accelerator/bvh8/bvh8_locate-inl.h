// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_LOCATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_LOCATE_INL_H
#undef RAYLAB_BVH8_LOCATE_INL_H
#else
#define RAYLAB_BVH8_LOCATE_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_vertices.h"
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

// Three coordinates as doubles and an unused fourth, in the vector types of GCC and Clang, which use whatever registers
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
// Reads four floats; another member of the ray follows the third.
HWY_INLINE FourDoubles three(const Ray& ray, std::size_t offset) {
    FourFloats read;
    std::memcpy(&read, reinterpret_cast<const std::byte*>(&ray) + offset, sizeof read);
    return in_doubles(read);
}
HWY_INLINE FourDoubles three(const Bvh8Vertices& vertices, std::size_t vertex) {
    const float* x = vertices.row(0) + vertex;
    return in_doubles(FourFloats{x[0], x[vertices.count()], x[2 * vertices.count()], 0});
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
HWY_INLINE FourDoubles next(FourDoubles x) { return __builtin_shufflevector(x, x, 1, 2, 0, 3); }  // y, z, x
HWY_INLINE FourDoubles last(FourDoubles x) { return __builtin_shufflevector(x, x, 2, 0, 1, 3); }  // z, x, y

// A cross product comes as z, x, y, and so does what is multiplied with it.
HWY_INLINE FourDoubles turned(FourDoubles x) { return last(x); }
HWY_INLINE FourDoubles turned_cross(FourDoubles a, FourDoubles b) { return a * next(b) - next(a) * b; }

// Of each the sum x + y + z, in this order; all four come as z, x, y.
HWY_INLINE FourDoubles sums_of_coordinates(FourDoubles u, FourDoubles v, FourDoubles w, FourDoubles volume) {
    const FourDoubles uv_zy = __builtin_shufflevector(u, v, 0, 4, 2, 6),
                      uv_x = __builtin_shufflevector(u, v, 1, 5, 3, 7);
    const FourDoubles wt_zy = __builtin_shufflevector(w, volume, 0, 4, 2, 6);
    const FourDoubles wt_x = __builtin_shufflevector(w, volume, 1, 5, 3, 7);
    const FourDoubles x = __builtin_shufflevector(uv_x, wt_x, 0, 1, 4, 5);
    const FourDoubles y = __builtin_shufflevector(uv_zy, wt_zy, 2, 3, 6, 7);
    const FourDoubles z = __builtin_shufflevector(uv_zy, wt_zy, 0, 1, 4, 5);
    return x + y + z;
}
#include "raylab/geometry/filter/triangle_volumes-inl.h"

// The hit of a triangle that the ray is known to hit inside its range, in the very bits of intersect(), and whether t
// is accurate.
//
// The formula is triangle_filter.h's, on three coordinates at once, and so are the error bounds (decide() there).
// Wherever floats decide that there is a hit, decide() decides so, too: half of Bvh8Ray's error_constant is to spare,
// eight times decide()'s bound of an edge.
//
// Lanes pay: without this function, tracing 20 000 rays to the bunny takes 9.8 % more instructions.
HWY_INLINE Bvh8Place place_of_hit(const Ray& ray, const Bvh8Vertices& vertices, std::size_t place) {
    const auto corners = vertices.corners(place);
    const FourDoubles o = three(ray, offsetof(Ray, origin)), d = three(ray, offsetof(Ray, direction));
    const FourDoubles a = three(vertices, corners[0]) - o, b = three(vertices, corners[1]) - o,
                      c = three(vertices, corners[2]) - o;
    const FourDoubles volumes = triangle_volumes(d, a, b, c);
    const double determinant = volumes[0] + volumes[1] + volumes[2];
    const FourDoubles at = volumes / determinant;

    // The error of t as decide() bounds it, times the determinant, with u the unit roundoff: 54 u m_x m_y m_z + |t| (3
    // (16 u e) + 6 u determinant), where m has the largest coordinates and e = |d_x| m_y m_z + ...; and the permitted
    // error, a fraction of |t| (determinant - 4 (16 u e)). A quarter of it is left for the rounding of this bound
    // itself.
    const FourDoubles m = larger(larger(size(a), size(b)), size(c));
    const FourDoubles areas = next(m) * last(m), edges = size(d) * areas;
    constexpr double u64 = unit_roundoff<double>, part = t_accuracy * 3 / 4;
    const double t = std::abs(at[3]), room = std::abs(determinant) * ((part - 6 * u64) / (48 * u64 + part * 64 * u64));
    const double error = m[0] * areas[0] * (54 * u64 / (48 * u64 + part * 64 * u64));
    return {at[3], at[1], at[2], error < t * (room - (edges[0] + edges[1] + edges[2]))};
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
