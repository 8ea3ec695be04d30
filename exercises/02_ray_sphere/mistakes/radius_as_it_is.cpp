// hint: radius_squared
// r in place of r squared, in the geometric way.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const double a = dot(ray.direction, ray.direction);
    const Vec3d L = sphere.center - ray.origin;
    const double middle = dot(L, ray.direction) / a;
    const Vec3d off = L - middle * ray.direction;
    const double inside = sphere.radius - dot(off, off);
    if (inside < 0) return std::nullopt;
    const double half = std::sqrt(inside / a);
    if (contains(ray.range, middle - half)) return middle - half;
    if (contains(ray.range, middle + half)) return middle + half;
    return std::nullopt;
}
