#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    // In the sphere's own measure, where it is the unit sphere at the origin, t is the same.
    const Vec3d origin = (ray.origin - sphere.center) / sphere.radius;
    const Vec3d direction = ray.direction / sphere.radius;
    const double a = dot(direction, direction);
    const Vec3d nearest = origin - direction * (dot(origin, direction) / a);
    const double room = 1 - dot(nearest, nearest);
    if (!(room >= 0)) return std::nullopt;
    const double middle = -dot(origin, direction) / a;
    const double half = std::sqrt(room / a);
    const auto inside = [&](double t) { return ray.range.min <= t && t <= ray.range.max; };
    if (inside(middle - half)) return middle - half;
    return inside(middle + half) ? std::optional(middle + half) : std::nullopt;
}
