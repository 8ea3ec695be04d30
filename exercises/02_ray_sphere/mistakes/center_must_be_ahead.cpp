// hint: center_behind
// The geometric way, which gives up where the centre is behind the start.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d to_center = sphere.center - ray.origin;
    const double length = glm::length(ray.direction);
    const double middle = dot(to_center, ray.direction) / length;
    if (middle < 0) return std::nullopt;
    const double beside = dot(to_center, to_center) - middle * middle, square = sphere.radius * sphere.radius;
    if (beside > square) return std::nullopt;
    const double half = std::sqrt(square - beside);
    for (const double distance : {middle - half, middle + half})
        if (contains(ray.range, distance / length)) return distance / length;
    return std::nullopt;
}
