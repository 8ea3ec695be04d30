// hint: range_in_metres
// Makes the direction unit, compares metres with the range, and turns them into t at the end.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const double metres_per_t = std::sqrt(dot(ray.direction, ray.direction));
    const Vec3d way = ray.direction / metres_per_t, to_center = sphere.center - ray.origin;
    const double middle = dot(to_center, way);
    const double square = sphere.radius * sphere.radius - dot(to_center, to_center) + middle * middle;
    if (square < 0) return std::nullopt;
    for (const double metres : {middle - std::sqrt(square), middle + std::sqrt(square)})
        if (contains(ray.range, metres)) return metres / metres_per_t;
    return std::nullopt;
}
