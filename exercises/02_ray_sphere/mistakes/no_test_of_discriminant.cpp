// hint: root_of_negative
// or: not_a_number
// No test whether there is a root at all; NaN passes the tests.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d oc = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), h = dot(oc, ray.direction),
                 c = dot(oc, oc) - sphere.radius * sphere.radius;
    const double s = std::sqrt(h * h - a * c);
    double t = (-h - s) / a;
    if (t < ray.range.min) t = (-h + s) / a;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    return t;
}
