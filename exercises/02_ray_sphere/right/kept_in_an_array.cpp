// Both roots in an array, the first in range wins.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <array>
#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d oc = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction), h = dot(oc, ray.direction);
    const double disc = h * h - a * (dot(oc, oc) - sphere.radius * sphere.radius);
    if (disc < 0) return std::nullopt;
    const std::array roots{(-h - std::sqrt(disc)) / a, (-h + std::sqrt(disc)) / a};
    const auto first = std::find_if(roots.begin(), roots.end(), [&](double t) { return contains(ray.range, t); });
    return first == roots.end() ? std::nullopt : std::optional(*first);
}
