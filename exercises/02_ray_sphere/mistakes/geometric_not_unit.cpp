// hint: unit_direction
// or: distance
// The geometric way, with a direction that is taken for unit.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d L = sphere.center - ray.origin;
    const double tca = dot(L, ray.direction);
    const double d2 = dot(L, L) - tca * tca, r2 = sphere.radius * sphere.radius;
    if (d2 > r2) return std::nullopt;
    const double thc = std::sqrt(r2 - d2);
    double t0 = tca - thc, t1 = tca + thc;
    if (t0 < ray.range.min) t0 = t1;
    if (t0 < ray.range.min || t0 > ray.range.max) return std::nullopt;
    return t0;
}
