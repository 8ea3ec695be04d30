// hint: far_root
// Returns the larger root where both are in range.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    Vec3d oc = sphere.center - ray.origin;
    double A = dot(ray.direction, ray.direction), B = -2.0 * dot(ray.direction, oc),
           C = dot(oc, oc) - sphere.radius * sphere.radius;
    double D = B * B - 4 * A * C;
    if (D < 0) return {};
    double s = std::sqrt(D), hi = (-B + s) / (2 * A), lo = (-B - s) / (2 * A);
    if (hi >= ray.range.min && hi <= ray.range.max) return hi;
    if (lo >= ray.range.min && lo <= ray.range.max) return lo;
    return {};
}
