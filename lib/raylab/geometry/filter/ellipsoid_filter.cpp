#include "raylab/geometry/filter/ellipsoid_filter.h"

#include "raylab/geometry/filter/moved_origin.h"
#include "raylab/geometry/filter/quadric_roots.h"

#include <algorithm>

namespace raylab::ellipsoid_filter {

namespace {

using What = SphereVerdict::What;
using namespace quadric_filter;

// As seen from a sphere, or from an ellipsoid that is stretched to one: the squares of upper bounds of the lengths of
// origin and direction, and of the radius; and what a product of them errs by, relatively.
struct Sizes {
    double from_center, of_direction, radius, relative;

    // A cross product counts twice, squared.
    ErrorBounds error_bounds() const {
        return {.a = relative * of_direction,
                .squared_b = relative * relative * from_center * of_direction,
                .c = relative * (from_center + radius),
                .discriminant = relative * of_direction * (radius + 2 * from_center)};
    }
    // Of what is too large, bounds become infinite, which decides nothing.
    bool stay_in_range() const { return of_direction > 0x1p-200 && radius > 0x1p-300; }
};

SphereVerdict decide_about_origin(const AlongRay<double>& f, const Sizes& sizes, const Interval<float>& range,
                                  Sides sides) {
    if (!(range.min >= 0) || !sizes.stay_in_range()) return {What::undecided};
    const ErrorBounds error_bound = sizes.error_bounds();
    if (surely_misses(f, error_bound)) return {What::missed};
    if (!(f.discriminant > error_bound.discriminant) || !(f.a > error_bound.a)) return {What::undecided};
    const Roots roots{f, error_bound, sizes.relative};
    if (!roots.are_well_known()) return {What::undecided};
    return sphere_filter::first_of([&] { return roots.first(); }, [&] { return roots.last(); }, range, sides);
}

SphereVerdict decide_from(const Vec3d& origin, const Vec3d& direction, const Interval<float>& range,
                          const Ellipsoid& ellipsoid, Sides sides, double relative) {
    const Vec3d radii = convert<double>(ellipsoid.radii), others = products_of_others<double>(radii);
    const double longest = std::max({others.x, others.y, others.z}), radius = radii.x * others.x;
    const Sizes sizes{dot(origin, origin) * (longest * longest), dot(direction, direction) * (longest * longest),
                      radius * radius, relative};
    return decide_about_origin(about_center<double>(origin, direction, radii), sizes, range, sides);
}

}  // namespace

SphereVerdict decide(const Ray& ray, const Ellipsoid& ellipsoid, Sides sides) {
    return decide_from(convert<double>(ray.origin) - convert<double>(ellipsoid.center), convert<double>(ray.direction),
                       ray.range, ellipsoid, sides, relative_at_rest);
}

SphereVerdict decide(const Ray& ray, const Ellipsoid& ellipsoid, const Affine& placement, const Motion& motion,
                     Sides sides) {
    const auto origin = origin_from_moved(ray, ellipsoid.center, placement, motion);
    if (!origin) return {What::undecided};
    return decide_from(*origin, convert<double>(ray.direction), ray.range, ellipsoid, sides, relative_at_rest);
}

SphereVerdict decide(const CarriedRay& ray, const Ellipsoid& ellipsoid, Sides sides) {
    return decide_from(ray.origin, ray.direction, ray.range, ellipsoid, sides, relative_carried);
}

SphereVerdict decide(const CarriedRay& ray, const Sphere& sphere, Sides sides) {
    const double radius = sphere.radius;
    const Sizes sizes{dot(ray.origin, ray.origin), dot(ray.direction, ray.direction), radius * radius,
                      relative_carried};
    return decide_about_origin(about_origin<double>(ray.origin, ray.direction, radius), sizes, ray.range, sides);
}

}  // namespace raylab::ellipsoid_filter
