// Compiled once for every instruction set (see wide_walk.cpp): a guard that opens again for the next.
#if defined(RAYLAB_WIDE_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_WIDE_TRIANGLES_INL_H
#undef RAYLAB_WIDE_TRIANGLES_INL_H
#else
#define RAYLAB_WIDE_TRIANGLES_INL_H
#endif

#include "raylab/accelerator/wide/wide_lanes-inl.h"
#include "raylab/accelerator/wide/wide_ray-inl.h"

#include <hwy/highway.h>

#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// A leaf's triangles, seen from the ray's origin and sheared along it: their areas about it, with a bound of their errors.
struct Areas {
    Floats u, v, w, error;
    Floats az, bz, cz, r;  // r: the largest sheared coordinate

    HWY_INLINE Areas(const WideRay& ray, const float* rows, std::size_t count) {
        const auto row = [&](std::size_t vertex, std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::LoadU(lanes_tag, rows + (3 * vertex + ray.axes[axis]) * count), all(ray.origin[axis]));
        };
        az = row(0, 2);
        bz = row(1, 2);
        cz = row(2, 2);
        const Floats sx = all(ray.shear[0]), sy = all(ray.shear[1]);
        const Floats ax = hn::Sub(row(0, 0), hn::Mul(sx, az)), ay = hn::Sub(row(0, 1), hn::Mul(sy, az));
        const Floats bx = hn::Sub(row(1, 0), hn::Mul(sx, bz)), by = hn::Sub(row(1, 1), hn::Mul(sy, bz));
        const Floats cx = hn::Sub(row(2, 0), hn::Mul(sx, cz)), cy = hn::Sub(row(2, 1), hn::Mul(sy, cz));
        u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
        v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
        w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
        r = hn::Max(hn::Max(larger(ax, ay), larger(bx, by)), larger(cx, cy));
        const Floats slope = hn::Add(hn::Mul(r, all(ray.error_quadratic)), all(ray.error_linear));
        error = hn::Add(hn::Mul(r, slope), all(ray.error_constant));
    }
    static HWY_INLINE Floats larger(Floats p, Floats q) { return hn::Max(hn::Abs(p), hn::Abs(q)); }

    // Not surely missed: the areas' signs are not surely mixed. A NaN leaves it open.
    HWY_INLINE std::uint32_t open() const {
        const Mask missed = hn::And(hn::Lt(hn::Min(hn::Min(u, v), w), hn::Neg(error)), hn::Gt(hn::Max(hn::Max(u, v), w), error));
        return ~bits(missed) & ((1u << lanes) - 1);
    }

    // Of those: surely hit, and surely not between the ray's start and end.
    struct Sure {
        std::uint32_t hit, out_of_range;
        std::uint32_t accurate;  // hit, with a t that doubles surely know well enough
    };

    // With z = (u az + v bz + w cz) / (u + v + w) the depth and t = z / direction: where the areas have one sign the numerator
    // errs by 3 Z error and 5 u Z of the denominator, this by 3 errors and 3 u of itself; Z is the largest depth.
    HWY_INLINE Sure sure(const WideRay& ray) const {
        const float steepness = std::abs(ray.direction[2]);
        const Floats positive = hn::Min(hn::Min(u, v), w), negative = hn::Neg(hn::Max(hn::Max(u, v), w));
        const Mask one_sign = hn::Or(hn::Gt(positive, error), hn::Gt(negative, error));
        const Floats sum = hn::Add(hn::Add(u, v), w), denominator = hn::Abs(sum);
        const Floats deep = hn::Max(larger(az, bz), hn::Abs(cz));
        const Floats numerator = hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz));
        const Floats along = hn::CopySignToAbs(hn::Abs(numerator), hn::Xor(hn::Xor(numerator, sum), all(ray.direction[2])));
        const Floats three_errors = hn::Mul(error, all(3 * spare));
        const Floats doubt = hn::Add(hn::Mul(deep, hn::Add(three_errors, hn::Mul(denominator, all(5 * unit * spare)))),
                                     all(0x1p-120f));  // where products underflow
        const Floats denominator_doubt = hn::Add(three_errors, hn::Mul(denominator, all(3 * unit * spare)));
        const Floats most = hn::Add(denominator, denominator_doubt), least = hn::Sub(denominator, denominator_doubt);
        const Floats soonest = hn::Sub(along, doubt), latest = hn::Add(along, doubt);
        const float start = ray.start * steepness, end = ray.end * steepness;
        const Mask inside = hn::And(hn::Gt(soonest, hn::Mul(most, all(start * spare))),
                                    hn::Lt(latest, hn::Mul(least, all(end / spare))));
        const Mask outside = hn::Or(hn::Lt(latest, hn::Mul(least, all(start / spare))),
                                    hn::Gt(soonest, hn::Mul(most, all(end * spare))));
        // The error of t in triangle_filter::decide() with M the triangle's largest coordinate, D the direction's and S the
        // denominator here: (54 u M^3 + t 144 u D M^2) / (D S), u = 2^-53, and t = Z / D with Z no larger than M. It is below
        // 2^-26 t where the numerator, S Z, is above 198 M^3 2^-26.
        const Floats reach = hn::Add(r, deep);
        const Mask accurate = hn::Gt(soonest, hn::Mul(hn::Mul(reach, reach), hn::Mul(reach, all(202 * 0x1p-26f))));
        const Mask hit = hn::And(one_sign, inside);
        return {bits(hit), bits(hn::And(one_sign, outside)), bits(hn::And(hit, accurate))};
    }
};

// Pluecker's test from the ray's origin, in floats, and t: the nearest hit of a leaf, if any comes before the end.
HWY_INLINE bool plain_hit(WideRay& ray, const float* rows, std::size_t count, std::size_t& place) {
    bool hit = false;
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto row = [&](std::size_t vertex, std::size_t axis) {
            return hn::Sub(hn::LoadU(lanes_tag, rows + i + (3 * vertex + ray.axes[axis]) * count), all(ray.origin[axis]));
        };
        const Floats ax = row(0, 0), ay = row(0, 1), az = row(0, 2), bx = row(1, 0), by = row(1, 1), bz = row(1, 2);
        const Floats cx = row(2, 0), cy = row(2, 1), cz = row(2, 2);
        const Floats dx = all(ray.direction[0]), dy = all(ray.direction[1]), dz = all(ray.direction[2]);
        const auto area = [](Floats p, Floats q, Floats r, Floats s) { return hn::Sub(hn::Mul(p, q), hn::Mul(r, s)); };
        const auto dot = [](Floats x, Floats y, Floats z, Floats p, Floats q, Floats r) {
            return hn::Add(hn::Add(hn::Mul(x, p), hn::Mul(y, q)), hn::Mul(z, r));
        };
        const Floats nx = area(by, cz, bz, cy), ny = area(bz, cx, bx, cz), nz = area(bx, cy, by, cx);
        const Floats u = dot(nx, ny, nz, dx, dy, dz);
        const Floats v = dot(area(cy, az, cz, ay), area(cz, ax, cx, az), area(cx, ay, cy, ax), dx, dy, dz);
        const Floats w = dot(area(ay, bz, az, by), area(az, bx, ax, bz), area(ax, by, ay, bx), dx, dy, dz);
        const Floats least = hn::Min(hn::Min(u, v), w), most = hn::Max(hn::Max(u, v), w), zero = hn::Zero(lanes_tag);
        const Mask inside = hn::Or(hn::Ge(least, zero), hn::Le(most, zero));
        std::uint32_t candidates = bits(inside) & ((1u << (count - i)) - 1);
        if (candidates == 0) continue;
        alignas(32) std::array<float, wide> t;
        hn::Store(hn::Div(dot(nx, ny, nz, ax, ay, az), hn::Add(hn::Add(u, v), w)), lanes_tag, t.data());
        for (; candidates != 0; candidates &= candidates - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(candidates));
            if (!(t[lane] >= ray.start && t[lane] <= ray.end)) continue;
            ray.end = t[lane];
            place = i + lane;
            hit = true;
        }
    }
    return hit;
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
