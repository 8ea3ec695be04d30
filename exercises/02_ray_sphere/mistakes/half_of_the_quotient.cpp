// hint: brackets
// The middle is not divided by d.d, half the chord is.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const double a = dot(ray.direction, ray.direction);
    const double middle = dot(sphere.center - ray.origin, ray.direction);
    const double power =
        glm::dot(ray.origin - sphere.center, ray.origin - sphere.center) - sphere.radius * sphere.radius;
    const double square = middle * middle - a * power;
    if (!(square >= 0)) return std::nullopt;
    const double half = std::sqrt(square) / a;
    for (const double t : {middle - half, middle + half})
        if (t >= ray.range.min && t <= ray.range.max) return t;
    return std::nullopt;
}
