// hint: half_b
// Half of b in a formula with four.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d oc = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), h = dot(oc, ray.direction),
                 c = dot(oc, oc) - std::pow(sphere.radius, 2);
    const double disc = h * h - 4 * a * c;
    if (disc < 0) return std::nullopt;
    const double s = std::sqrt(disc), t1 = (-h - s) / (2 * a), t2 = (-h + s) / (2 * a);
    if (t1 >= ray.range.min && t1 <= ray.range.max) return t1;
    if (t2 >= ray.range.min && t2 <= ray.range.max) return t2;
    return std::nullopt;
}
