// hint: inside
// Which of the two it is says the sign, and the range is asked of that one alone.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), b = dot(f, ray.direction);
    const double discriminant = b * b - a * (dot(f, f) - sphere.radius * sphere.radius);
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(discriminant), near = (-b - root) / a, far = (-b + root) / a;
    const double t = near > 0 ? near : far;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    return t;
}
