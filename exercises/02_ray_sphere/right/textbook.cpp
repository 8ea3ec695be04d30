#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction);
    const double b = 2 * dot(f, ray.direction);
    const double c = dot(f, f) - sphere.radius * sphere.radius;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    for (const double sign : {-1.0, 1.0}) {
        const double t = (-b + sign * std::sqrt(discriminant)) / (2 * a);
        if (ray.range.min <= t && t <= ray.range.max) return t;
    }
    return std::nullopt;
}
