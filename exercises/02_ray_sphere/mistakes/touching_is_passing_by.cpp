// hint: tangent
// A line whose distance from the centre is the radius counts as one that passes by.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const double a = dot(ray.direction, ray.direction);
    const double middle = dot(sphere.center - ray.origin, ray.direction) / a;
    const Vec3d nearest = ray.origin + middle * ray.direction - sphere.center;
    const double radius_squared = sphere.radius * sphere.radius;
    if (dot(nearest, nearest) >= radius_squared) return std::nullopt;

    const double half = std::sqrt((radius_squared - dot(nearest, nearest)) / a);
    for (const double t : {middle - half, middle + half})
        if (contains(ray.range, t)) return t;
    return std::nullopt;
}
