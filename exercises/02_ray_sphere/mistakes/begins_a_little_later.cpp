// hint: own_limits
// Leaves out a ten-thousandth at the range's beginning, against hits of what the ray leaves.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), b = dot(f, ray.direction);
    const double discriminant = b * b - a * (dot(f, f) - sphere.radius * sphere.radius);
    if (discriminant < 0) return std::nullopt;
    const double from = ray.range.min + 1e-4;
    for (const double root : {-std::sqrt(discriminant), std::sqrt(discriminant)})
        if (const double t = (root - b) / a; t >= from && t <= ray.range.max) return t;
    return std::nullopt;
}
