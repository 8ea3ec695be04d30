#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>
#include <utility>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction);
    const double b = dot(f, ray.direction);
    const double c = dot(f, f) - sphere.radius * sphere.radius;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;
    const double q = b > 0 ? -b - std::sqrt(discriminant) : -b + std::sqrt(discriminant);
    double first = q / a;
    double second = q == 0 ? first : c / q;
    if (first > second) std::swap(first, second);
    if (ray.range.min <= first && first <= ray.range.max) return first;
    if (ray.range.min <= second && second <= ray.range.max) return second;
    return std::nullopt;
}
