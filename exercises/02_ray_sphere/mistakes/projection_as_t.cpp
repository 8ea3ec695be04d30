// hint: distance
// or: unit_direction
// The geometric way with a unit direction, and t in metres.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const double len = glm::length(ray.direction);
    const Vec3d dir = ray.direction / len;
    const Vec3d L = sphere.center - ray.origin;
    const double tca = dot(L, dir), d2 = dot(L, L) - tca * tca, r2 = sphere.radius * sphere.radius;
    if (d2 > r2) return std::nullopt;
    const double thc = std::sqrt(r2 - d2);
    for (double t : {tca - thc, tca + thc})
        if (t >= ray.range.min && t <= ray.range.max) return t;
    return std::nullopt;
}
