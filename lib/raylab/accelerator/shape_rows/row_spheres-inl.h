// Compiled once for every instruction set (see row_questions.cpp): a guard that opens again for the next.
#if defined(RAYLAB_ROW_SPHERES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_ROW_SPHERES_INL_H
#undef RAYLAB_ROW_SPHERES_INL_H
#else
#define RAYLAB_ROW_SPHERES_INL_H
#endif

#include "raylab/accelerator/shape_rows/row_ray-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

HWY_INLINE Doubles times(Doubles numbers, double factor) { return hn::Mul(numbers, number(factor)); }

#include "raylab/geometry/filter/sphere_terms-inl.h"

// A ray and four spheres.
struct SpheresAlong {
    SphereTerms<Doubles> terms;
    Bools away, toward;  // the ray goes, surely: b is known to 2^-41 of itself

    HWY_INLINE Bools outside() const { return hn::Gt(terms.c, terms.c_error); }  // where the ray begins
    // The line passes by, or the ray begins outside and goes away: surely. A NaN leaves it open.
    HWY_INLINE Bools missed() const {
        return hn::Or(hn::Lt(terms.discriminant + terms.discriminant_error, number(0)), hn::And(outside(), away));
    }
};

class RowSpheres {
public:
    HWY_INLINE explicit RowSpheres(const RowRay& ray)
        : ray_(ray), a_(dot(ray.dx, ray.dy, ray.dz, ray.dx, ray.dy, ray.dz)) {}

    HWY_INLINE SpheresAlong along(const ShapeRows::Spheres& rows, std::size_t i) const {
        const Doubles x = ray_.ox - load(rows.x, i), y = ray_.oy - load(rows.y, i), z = ray_.oz - load(rows.z, i);
        const auto terms = sphere_terms(ray_.dx, ray_.dy, ray_.dz, x, y, z, a_, load(rows.squared_radius, i));
        const Doubles square = terms.b * hn::Abs(terms.b), smallest = times(a_ * terms.distance, 0x1p-20);
        return {terms, hn::Gt(square, smallest), hn::Lt(square, times(smallest, -1))};
    }

    // Entered before t = end, by a ray that begins outside: at the latest where it is nearest to the center, at -b / a.
    HWY_INLINE Bools entered(const SpheresAlong& s, double end) const {
        const Bools soon = hn::Gt(times(a_, end), times(s.terms.b, -1 - 0x1p-30));
        const Bools crossing = hn::Gt(s.terms.discriminant, s.terms.discriminant_error);
        return hn::And(hn::And(s.outside(), s.toward), hn::And(soon, crossing));
    }

private:
    const RowRay& ray_;
    const Doubles a_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
