// hint: center_behind
// Who moves away from the centre is told that there is no hit.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), b = dot(f, ray.direction);
    const double c = dot(f, f) - sphere.radius * sphere.radius;
    const double root = b * b - a * c;
    if (b > 0 || root < 0) return std::nullopt;
    const double near = (-b - std::sqrt(root)) / a, far = (-b + std::sqrt(root)) / a;
    if (contains(ray.range, near)) return near;
    return contains(ray.range, far) ? std::optional(far) : std::nullopt;
}
