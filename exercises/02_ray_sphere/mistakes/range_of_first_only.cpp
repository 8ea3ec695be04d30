// hint: behind
// The second root is not compared with the end of the range.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d oc = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), b = 2 * dot(oc, ray.direction),
                 c = dot(oc, oc) - sphere.radius * sphere.radius;
    const double disc = b * b - 4 * a * c;
    if (disc < 0) return std::nullopt;
    const double near = (-b - std::sqrt(disc)) / (2 * a);
    if (near >= ray.range.min && near <= ray.range.max) return near;
    const double far = (-b + std::sqrt(disc)) / (2 * a);
    return far >= ray.range.min ? std::optional(far) : std::nullopt;
}
