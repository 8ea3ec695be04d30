// Compiled once for every instruction set (see row_questions.cpp): a guard that opens again for the next.
#if defined(RAYLAB_ROW_SPHERES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_ROW_SPHERES_INL_H
#undef RAYLAB_ROW_SPHERES_INL_H
#else
#define RAYLAB_ROW_SPHERES_INL_H
#endif

#include "raylab/accelerator/shape_rows/row_ray-inl.h"

#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// A ray and spheres: F(t) = a t^2 + 2 b t + c, its discriminant b^2 - a c, as plain doubles compute them.
//
// With f = origin - center, u = 2^-53 and d, r the lengths: f carries one rounding; b errs by 4 u d |f|, b^2 by 9 u a
// f.f; c by 6 u f.f + u r^2, a by 2 u a, a c by a (9 u f.f + 4 u r^2), their difference by u a (2 f.f + r^2) of its
// own. That makes 20 u a (f.f + r^2) at most, of which `error_bound` is 32. Floats in doubles neither over- nor
// underflow there.
//
// sphere_filter.h has the discriminant as a r^2 - |d x f|^2, which cancels less. Here it would take 3.4 % more
// instructions of the picture of tests/bench/mirror_and_glass.toml, and only leave fewer spheres to that filter.
struct SpheresAlong {
    Doubles b, c, c_error_bound, discriminant, error_bound;
    Bools turned;  // b is known to 2^-41 of itself

    HWY_INLINE Bools outside() const { return hn::Gt(c, c_error_bound); }  // where the ray begins
    // The line passes by, or the ray begins outside and goes away: surely. A NaN leaves it open.
    HWY_INLINE Bools missed() const {
        const Bools away = hn::And(hn::And(outside(), turned), hn::Gt(b, number(0)));
        return hn::Or(hn::Lt(hn::Add(discriminant, error_bound), number(0)), away);
    }
};

class RowSpheres {
public:
    HWY_INLINE explicit RowSpheres(const RowRay& ray)
        : ray_(ray), a_(dot(ray.dx, ray.dy, ray.dz, ray.dx, ray.dy, ray.dz)) {}

    HWY_INLINE SpheresAlong along(const ShapeRows::Spheres& rows, std::size_t i) const {
        const Doubles x = hn::Sub(ray_.ox, load(rows.x, i)), y = hn::Sub(ray_.oy, load(rows.y, i));
        const Doubles z = hn::Sub(ray_.oz, load(rows.z, i));
        const Doubles distance = dot(x, y, z, x, y, z);
        SpheresAlong s;
        const Doubles squared_radius = load(rows.squared_radius, i);
        s.b = dot(ray_.dx, ray_.dy, ray_.dz, x, y, z);
        s.c = hn::Sub(distance, squared_radius);
        s.c_error_bound = hn::Mul(hn::Add(distance, squared_radius), number(32 * 0x1p-53));
        const Doubles squared_b = hn::Mul(s.b, s.b);
        s.discriminant = hn::Sub(squared_b, hn::Mul(a_, s.c));
        s.error_bound = hn::Mul(a_, s.c_error_bound);
        s.turned = hn::Gt(squared_b, hn::Mul(hn::Mul(a_, distance), number(0x1p-20)));
        return s;
    }

    // Entered before t = end, by a ray that begins outside: at the latest where it is nearest to the center, at -b / a.
    HWY_INLINE Bools entered(const SpheresAlong& s, double end) const {
        const Bools toward = hn::And(s.turned, hn::Lt(s.b, number(0)));
        const Bools soon = hn::Gt(hn::Mul(a_, number(end)), hn::Mul(s.b, number(-1 - 0x1p-30)));
        return hn::And(hn::And(s.outside(), toward), hn::And(soon, hn::Gt(s.discriminant, s.error_bound)));
    }

private:
    const RowRay& ray_;
    const Doubles a_;
};

// The terms of the spheres' equations, kept until an entry is computed from them.
struct SphereEntries {
    alignas(64) std::array<double, ShapeRows::largest> b, c,
        squared_surd;  // c is no larger than the exact one, the last no smaller

    HWY_INLINE void keep(const SpheresAlong& s, std::size_t place) {
        hn::Store(s.b, doubles_tag, b.data() + place);
        hn::Store(hn::Sub(s.c, s.c_error_bound), doubles_tag, c.data() + place);
        hn::Store(hn::Add(s.discriminant, hn::Add(s.error_bound, s.error_bound)), doubles_tag,
                  squared_surd.data() + place);
    }

    // A lower bound of c / (|b| + sqrt(discriminant)), the smaller root seen from outside; zero from inside. The second
    // error bound makes up for b's error: it adds more than 15 u d sqrt(f.f + r^2) to the root, since the discriminant
    // is at most a r^2.
    HWY_INLINE double at(std::size_t place) const {
        const double way = c[place] > 0 ? c[place] : 0;
        return way == 0 ? 0 : way / (std::abs(b[place]) + std::sqrt(squared_surd[place])) * (1 - 0x1p-40);
    }
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
