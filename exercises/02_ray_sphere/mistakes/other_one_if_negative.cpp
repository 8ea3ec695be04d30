// hint: inside
// Takes the second crossing where the first one is negative, and not where it is before the range.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const double a = dot(ray.direction, ray.direction);
    const Vec3d way = sphere.center - ray.origin;
    const double tca = dot(way, ray.direction) / a;
    const Vec3d off = way - tca * ray.direction;
    const double d2 = dot(off, off), r2 = sphere.radius * sphere.radius;
    if (d2 > r2) return std::nullopt;
    const double thc = std::sqrt((r2 - d2) / a);
    double t = tca - thc;
    if (t < 0) t = tca + thc;
    if (!contains(ray.range, t)) return std::nullopt;
    return t;
}
