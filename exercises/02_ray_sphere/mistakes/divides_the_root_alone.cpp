// hint: brackets
// -b - root / (2 a), without brackets around what is divided.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction);
    const double b = 2 * dot(f, ray.direction);
    const double c = dot(f, f) - sphere.radius * sphere.radius;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    const double near = -b - std::sqrt(discriminant) / (2 * a);
    const double far = -b + std::sqrt(discriminant) / (2 * a);
    if (contains(ray.range, near)) return near;
    if (contains(ray.range, far)) return far;
    return std::nullopt;
}
