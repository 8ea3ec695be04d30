// hint: center_behind
// Gives up where the range ends before the middle of the chord.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), b = dot(f, ray.direction);
    const double discriminant = b * b - a * (dot(f, f) - sphere.radius * sphere.radius);
    if (discriminant < 0) return std::nullopt;
    if (-b / a > ray.range.max) return std::nullopt;
    const double root = std::sqrt(discriminant), near = (-b - root) / a, far = (-b + root) / a;
    for (const double t : {near, far})
        if (t >= ray.range.min && t <= ray.range.max) return t;
    return std::nullopt;
}
