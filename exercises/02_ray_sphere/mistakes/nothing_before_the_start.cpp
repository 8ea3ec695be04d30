// hint: own_limits
// Leaves out what is behind the start before it asks the range, which may begin there.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const double speed = glm::length(ray.direction);
    const Vec3d unit = ray.direction / speed, to_center = sphere.center - ray.origin;
    const double foot = dot(to_center, unit);
    const Vec3d off = to_center - foot * unit;
    const double half_squared = sphere.radius * sphere.radius - dot(off, off);
    if (half_squared < 0) return std::nullopt;
    for (const double side : {-1.0, 1.0}) {
        const double t = (foot + side * std::sqrt(half_squared)) / speed;
        if (t < 0) continue;
        if (contains(ray.range, t)) return t;
    }
    return std::nullopt;
}
