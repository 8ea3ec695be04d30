#include "raylab/geometry/filter/sphere_filter.h"

#include "raylab/geometry/filter/quadric_roots.h"

namespace raylab::sphere_filter {

// With p and d off by a part of their lengths, products of two and of four of them are off by two and four such parts
// of the lengths' product: half as much again is to spare for their products of each other, and for roundings, of which
// a part is a thousand. A cross product counts twice, squared.
SphereVerdict decide(const CarriedRay& ray, const Sphere& sphere, Sides sides) {
    constexpr double relative = 8 * CarriedRay::off;
    const double r = sphere.radius;
    const AlongRay<double> f = about_origin<double>(ray.origin, ray.direction, r);
    const double p = dot(ray.origin, ray.origin), q = f.a;
    const quadric_filter::ErrorBounds error_bound{.a = relative * q,
                                                  .squared_b = relative * relative * p * q,
                                                  .c = relative * (p + r * r),
                                                  .discriminant = relative * q * (r * r + 2 * p)};
    const bool stays_in_range = q > 0x1p-80 && r * r > 0x1p-200;  // what is too large makes bounds infinite
    if (!(ray.range.min >= 0) || !stays_in_range) return {SphereVerdict::What::undecided};
    if (f.c > error_bound.c && f.b > 0 && f.b * f.b > 4 * error_bound.squared_b) return {SphereVerdict::What::missed};
    if (f.discriminant < -error_bound.discriminant) return {SphereVerdict::What::missed};
    if (!(f.discriminant > error_bound.discriminant)) return {SphereVerdict::What::undecided};
    const quadric_filter::Roots roots{f, error_bound, relative};
    if (!roots.are_well_known()) return {SphereVerdict::What::undecided};
    return first_of([&] { return roots.first(); }, [&] { return roots.last(); }, ray.range, sides);
}

}  // namespace raylab::sphere_filter
