// hint: inside
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    Vec3d l = sphere.center - ray.origin;
    double a = dot(ray.direction, ray.direction), h = dot(ray.direction, l),
           c = dot(l, l) - sphere.radius * sphere.radius;
    if (c < 0) return std::nullopt;
    double d = h * h - a * c;
    if (d < 0) return {};
    double q = std::sqrt(d);
    for (double t : {(h - q) / a, (h + q) / a})
        if (t >= ray.range.min && t <= ray.range.max) return t;
    return std::nullopt;
}
