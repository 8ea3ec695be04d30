// hint: own_limits
// Keeps away from the start by a fixed length, as a shadow ray would.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d oc = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), h = dot(oc, ray.direction),
                 c = dot(oc, oc) - sphere.radius * sphere.radius;
    const double disc = h * h - a * c;
    if (disc < 0) return std::nullopt;
    const double from = std::max(ray.range.min, 0.001);
    for (const double side : {-1.0, 1.0}) {
        const double t = (-h + side * std::sqrt(disc)) / a;
        if (t >= from && t <= ray.range.max) return t;
    }
    return std::nullopt;
}
