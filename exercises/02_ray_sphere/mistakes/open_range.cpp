// hint: closed_range
#include "raylab/geometry/nearest_sphere_hit.h"

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
    if (ray.range.min < near && near < ray.range.max) return near;
    if (ray.range.min < far && far < ray.range.max) return far;
    return std::nullopt;
}
