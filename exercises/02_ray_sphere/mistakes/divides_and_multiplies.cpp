// hint: precedence
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    Vec3d oc = ray.origin - sphere.center;
    double a = dot(ray.direction, ray.direction), b = 2 * dot(oc, ray.direction),
           c = dot(oc, oc) - sphere.radius * sphere.radius;
    double d = b * b - 4 * a * c;
    if (d < 0) return std::nullopt;
    double q = std::sqrt(d);
    for (double t : {(-b - q) / 2 * a, (-b + q) / 2 * a})
        if (t >= ray.range.min && t <= ray.range.max) return t;
    return std::nullopt;
}
