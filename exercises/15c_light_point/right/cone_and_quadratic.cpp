#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from, axis = glm::normalize(way);
    const double squared = dot(way, way);
    const double cosine_max = std::sqrt(1 - radius * radius / squared);
    const double cosine = (1 - u) + u * cosine_max, sine = std::sqrt(1 - cosine * cosine);
    const double angle = 2 * std::numbers::pi * v;
    const Vec3d x = glm::normalize(cross(std::abs(axis.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0}, axis));
    const Vec3d direction = sine * std::cos(angle) * x + sine * std::sin(angle) * cross(axis, x) + cosine * axis;
    // The ray from + t direction: t^2 - 2 t (direction . way) + way . way - radius^2 = 0, and of its solutions the
    // less.
    const double middle = dot(direction, way);
    const double t = middle - std::sqrt(std::max(0.0, middle * middle - (squared - radius * radius)));
    return {from + t * direction, 1 / (2 * std::numbers::pi * (1 - cosine_max))};
}
