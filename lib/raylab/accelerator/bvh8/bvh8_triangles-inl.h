// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_TRIANGLES_INL_H
#undef RAYLAB_BVH8_TRIANGLES_INL_H
#else
#define RAYLAB_BVH8_TRIANGLES_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_ray-inl.h"
#include "raylab/accelerator/bvh8/bvh8_vertices-inl.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// A leaf's vertices, seen from the ray's origin and sheared along it; z is the depth.
HWY_INLINE Tables sheared_vertices(const Bvh8Ray& ray, const Bvh8Vertices& vertices) {
    const Floats ox = all(ray.origin[0]), oy = all(ray.origin[1]), oz = all(ray.origin[2]);
    const Floats sx = all(ray.shear[0]), sy = all(ray.shear[1]);
    const std::array<std::size_t, 3> axes{static_cast<std::size_t>(ray.axes[0]), static_cast<std::size_t>(ray.axes[1]),
                                          static_cast<std::size_t>(ray.axes[2])};
    return Tables(vertices, axes, [&](Floats x, Floats y, Floats z) HWY_ATTR {
        const Floats depth = hn::Sub(z, oz);
        return Moved{hn::NegMulAdd(sx, depth, hn::Sub(x, ox)), hn::NegMulAdd(sy, depth, hn::Sub(y, oy)), depth};
    });
}

// A leaf's triangles, seen from the ray's origin and sheared along it: their areas about it, with error bounds.
struct Areas {
    Floats u, v, w, error;

    HWY_INLINE Areas(const Bvh8Ray& ray, const Tables& sheared, const Corners& corners) {
        const Floats ax = corners.of<0>(sheared.x), ay = corners.of<0>(sheared.y);
        const Floats bx = corners.of<1>(sheared.x), by = corners.of<1>(sheared.y);
        const Floats cx = corners.of<2>(sheared.x), cy = corners.of<2>(sheared.y);
        u = hn::MulSub(cx, by, hn::Mul(cy, bx));
        v = hn::MulSub(ax, cy, hn::Mul(ay, cx));
        w = hn::MulSub(bx, ay, hn::Mul(by, ax));
        const Floats linear = all(ray.error_linear);
        const Floats r = larger(larger(larger(hn::Abs(ax), hn::Abs(ay)), larger(hn::Abs(bx), hn::Abs(by))),
                                larger(larger(hn::Abs(cx), hn::Abs(cy)), linear));
        error = hn::MulAdd(r, hn::MulAdd(r, all(ray.error_quadratic), linear), all(least_error));
    }
    HWY_INLINE Floats smallest() const { return hn::Min(hn::Min(u, v), w); }
    HWY_INLINE Floats largest() const { return hn::Max(hn::Max(u, v), w); }
    // Of two that are not negative.
    static HWY_INLINE Floats larger(Floats p, Floats q) {
        return hn::BitCast(lanes_tag, hn::Max(hn::BitCast(integers_tag, p), hn::BitCast(integers_tag, q)));
    }

    // A mask of those of the first `count` triangles that are not surely missed: whose areas do not surely have
    // different signs. A NaN leaves a triangle open. (The signs are known much sooner than the error bounds, which
    // seldom change what they say: so there are two branches, of which only the first is hard to predict. Both ask the
    // same in different words: otherwise GCC would merge them into one that waits for the error bounds, which costs 1
    // to 2 % of a ray's time.)
    HWY_INLINE std::uint32_t open(std::size_t count) const {
        const std::uint32_t all_of_them = (1u << std::min(count, lanes)) - 1;
        const std::uint32_t of_one_sign = ~signs(hn::Or(hn::Xor(u, v), hn::Xor(u, w))) & all_of_them;
        if (of_one_sign == 0) {
            const std::uint32_t missed = bits(hn::Gt(hn::Min(hn::Neg(smallest()), largest()), error));
            if ((~missed & all_of_them) == 0) return 0;
        }
        // (The former are among the latter: so the compiler knows that there are some.)
        return of_one_sign |
               (~bits(hn::And(hn::Lt(smallest(), hn::Neg(error)), hn::Gt(largest(), error))) & all_of_them);
    }

    // Of an area. It is more than an area's products may underflow by; and the sum of three areas that are larger,
    // beyond 2^-65, is so large that what other products may underflow by, 2^-150 each, stays below Bvh8Ray::underflow
    // when it is divided by this sum, and that slowness, at most 2^60, divided by it is finite.
    static constexpr float least_error = 0x1p-66f;
};

// Of those, which are surely hit between the ray's start and end, which surely not there, and bounds of t for the
// former.
//
// Depth along the ray's dominant axis is z = a_z + (v (b_z - a_z) + w (c_z - a_z)) / (u + v + w), and t = z /
// direction. Let S be the sum, s the range of the three depths, e the error of an area and u here the unit roundoff. z
// is a mean of the depths, so none of them is farther from it than s, and all three together no farther than 2 s: with
// wrong weights it errs by 2 e s / S at most. The depths, what is added to a_z (no more than s) and its sums are
// rounded, too: that is 2 e s / S + 2 u (|a_z| + 4 s). Where the ray is displaced, each depth errs by as much and s by
// twice that, of which 2 e / S is less than two thirds: z errs by less than three times as much.
//
// A bound of t is a number and a multiple of 1 / (direction S): a ray waits for that quotient, so nothing but a product
// and a sum comes after it. The roundings of 1 / direction, of a_z times it and of the number, of the quotient, of its
// factor and of product and sum add u (4 |a_z| + 5 s): together less than 2 e s / S + 6 u (|a_z| + 3 s).
class Sure {
public:
    HWY_INLINE Sure(const Areas& of, const Bvh8Ray& ray, const Tables& sheared, const Corners& corners) {
        const Floats az = corners.of<0>(sheared.z), bz = corners.of<1>(sheared.z), cz = corners.of<2>(sheared.z);
        const Floats sum = hn::Add(hn::Add(of.u, of.v), of.w), slowness = all(ray.slowness);
        const Floats quotient = hn::Div(slowness, sum);
        known_ = is_less(of.error, hn::Max(of.smallest(), hn::Neg(of.largest())));

        const Floats b = hn::Sub(bz, az), c = hn::Sub(cz, az);
        const Floats range = hn::Sub(hn::Max(hn::Max(az, bz), cz), hn::Min(hn::Min(az, bz), cz));
        const Floats beyond_a = hn::MulAdd(of.v, b, hn::Mul(of.w, c));
        const Floats sign = hn::And(hn::Xor(sum, slowness), hn::Set(lanes_tag, -0.0f));
        const Floats error_beyond_a = hn::Xor(hn::Mul(of.error, hn::Mul(range, all(2 * spare))), sign);
        const Floats at_a = hn::Mul(az, slowness);
        const Floats reach = hn::MulAdd(range, all(3), hn::Abs(az));
        const Floats error_at_a =
            hn::Mul(hn::MulAdd(reach, all(Bvh8Ray::depth_error), all(ray.least_depth_error)), hn::Abs(slowness));
        first_ = hn::MulAdd(hn::Sub(beyond_a, error_beyond_a), quotient, hn::Sub(at_a, error_at_a));
        last_ = hn::MulAdd(hn::Add(beyond_a, error_beyond_a), quotient, hn::Add(at_a, error_at_a));
    }

    // Those that the ray's line surely crosses.
    HWY_INLINE std::uint32_t crossed() const { return signs(known_); }
    // Those that it surely crosses from behind: with d the direction and (a, b, c) the corners, the area times d_z is
    // -d . (b x c).
    HWY_INLINE std::uint32_t crossed_from_behind(const Areas& of, const Bvh8Ray& ray) const {
        return crossed() & signs(hn::Xor(of.u, all(ray.slowness)));
    }
    HWY_INLINE std::uint32_t hit(const Bvh8Ray& ray) const { return hit_before(ray.end, ray); }
    // (The end may be negative, but what comes after the start is not.)
    HWY_INLINE std::uint32_t hit_before(float end, const Bvh8Ray& ray) const {
        return signs(hn::And(known_, hn::And(is_less(all(ray.start), first_), is_less(last_, all(end)))));
    }
    HWY_INLINE std::uint32_t out_of_range(const Bvh8Ray& ray) const {
        return signs(hn::And(known_, hn::Or(is_less(last_, all(ray.start)), is_less(all(ray.end), first_))));
    }

    // Bounds of t, lane by lane.
    struct Bounds {
        alignas(32) std::array<float, bvh8_width> soonest, latest;
    };
    HWY_INLINE Bounds bounds() const {
        Bounds of;
        hn::Store(first_, lanes_tag, of.soonest.data());
        hn::Store(last_, lanes_tag, of.latest.data());
        return of;
    }

private:
    // Where first_ or last_ may be a NaN, known_ is 0: the quotient is finite, where areas exceed their errors.
    Integers known_;
    Floats first_, last_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
