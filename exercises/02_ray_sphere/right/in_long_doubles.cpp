// Textbook, in long doubles.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    using Wide = glm::vec<3, long double, glm::defaultp>;
    const Wide f = Wide(ray.origin) - Wide(sphere.center), d(ray.direction);
    const long double a = glm::dot(d, d), b = 2 * glm::dot(f, d);
    const long double c = glm::dot(f, f) - static_cast<long double>(sphere.radius) * sphere.radius;
    const long double disc = b * b - 4 * a * c;
    if (disc < 0) return std::nullopt;
    for (const long double side : {-1.0L, 1.0L}) {
        const long double t = (-b + side * std::sqrt(disc)) / (2 * a);
        if (t >= ray.range.min && t <= ray.range.max) return static_cast<double>(t);
    }
    return std::nullopt;
}
