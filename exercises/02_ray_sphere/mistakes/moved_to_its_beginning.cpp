// hint: infinite_end
// Moves the ray to where its range begins, which may be infinitely far.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const auto [from, to] = ray.range;
    const Vec3d f = ray.origin + from * ray.direction - sphere.center;
    const double a = dot(ray.direction, ray.direction), b = dot(f, ray.direction);
    const double discriminant = b * b - a * (dot(f, f) - sphere.radius * sphere.radius);
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    for (const double t : {(-b - root) / a, (-b + root) / a})
        if (t >= 0 && from + t <= to) return from + t;
    return std::nullopt;
}
