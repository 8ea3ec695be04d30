// hint: axis_not_unit
// or: crowd_in_the_middle
// Axes of its own, by a cross product that is not of length 1.
#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double distance = glm::length(center - from), sine_max = radius / distance;
    const double cosine_max = std::sqrt(1 - sine_max * sine_max), turn = 2 * std::numbers::pi * v;
    const Vec3d ahead = (center - from) / distance, across = cross(Vec3d{0, 0, 1}, ahead), up = cross(ahead, across);
    const double cosine = 1 - u * (1 - cosine_max), sine = std::sqrt(1 - cosine * cosine);
    const Vec3d ray = glm::normalize(sine * std::cos(turn) * across + sine * std::sin(turn) * up + cosine * ahead);
    const double middle = dot(ray, center - from);
    const double root = std::sqrt(std::max(0.0, middle * middle - distance * distance + radius * radius));
    return {from + (middle - root) * ray, 1 / (2 * std::numbers::pi * (1 - cosine_max))};
}
