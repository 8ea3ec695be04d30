// hint: own_limits
#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction);
    const double b = dot(f, ray.direction);
    const double c = dot(f, f) - sphere.radius * sphere.radius;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;
    const double near = (-b - std::sqrt(discriminant)) / a;
    const double far = (-b + std::sqrt(discriminant)) / a;
    const double to = std::min(1000.0, ray.range.max);
    if (ray.range.min <= near && near <= to) return near;
    if (ray.range.min <= far && far <= to) return far;
    return std::nullopt;
}
