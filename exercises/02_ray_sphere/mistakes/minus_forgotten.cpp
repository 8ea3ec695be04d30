// hint: from_center
// b without its minus.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d oc = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), b = dot(oc, ray.direction),
                 c = dot(oc, oc) - sphere.radius * sphere.radius;
    if (b * b - a * c < 0) return std::nullopt;
    const double root = std::sqrt(b * b - a * c);
    const double t1 = (b - root) / a, t2 = (b + root) / a;
    if (t1 >= ray.range.min && t1 <= ray.range.max) return t1;
    if (t2 >= ray.range.min && t2 <= ray.range.max) return t2;
    return std::nullopt;
}
