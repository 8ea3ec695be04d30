// hint: inside
// A centre behind the start means no hit, which is wrong inside the sphere; and the first root only.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d oc = ray.origin - sphere.center;
    const double half_b = dot(oc, ray.direction), a = dot(ray.direction, ray.direction);
    const double disc = half_b * half_b - a * (dot(oc, oc) - sphere.radius * sphere.radius);
    if (disc < 0.0) return std::nullopt;
    const double root = (-half_b - std::sqrt(disc)) / a;
    if (root < ray.range.min || ray.range.max < root) return std::nullopt;
    return root;
}
