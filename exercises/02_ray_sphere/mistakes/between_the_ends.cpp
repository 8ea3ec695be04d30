// hint: closed_range
// Looks through both roots for one that lies between the ends, and the ends themselves do not.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <array>
#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d to_center = sphere.center - ray.origin;
    const double a = dot(ray.direction, ray.direction), middle = dot(to_center, ray.direction);
    const double square = middle * middle - a * (dot(to_center, to_center) - sphere.radius * sphere.radius);
    if (!(square >= 0)) return std::nullopt;
    const double half = std::sqrt(square);
    const std::array roots{(middle - half) / a, (middle + half) / a};
    const auto lies_between = [&](double t) { return t > ray.range.min && t < ray.range.max; };
    const auto first = std::find_if(roots.begin(), roots.end(), lies_between);
    if (first == roots.end()) return std::nullopt;
    return *first;
}
