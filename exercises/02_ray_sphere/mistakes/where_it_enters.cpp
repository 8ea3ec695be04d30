// hint: behind
// Half a chord before the foot of the perpendicular is where the line enters, and no range is asked for.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d to_center = sphere.center - ray.origin;
    const double a = dot(ray.direction, ray.direction);
    const double foot = dot(to_center, ray.direction) / a;
    const Vec3d beside = to_center - foot * ray.direction;
    const double room = sphere.radius * sphere.radius - dot(beside, beside);
    if (room >= 0) return foot - std::sqrt(room / a);
    return std::nullopt;
}
