// hint: nothing_along_an_axis
// or: not_a_number, one_group
// Takes cross products with y for the axes, which are nothing where the light is above or below.
#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double distance = glm::length(way), sine_max = radius / distance;
    const double cosine_max = std::sqrt(1 - sine_max * sine_max);
    const double cosine = 1 + u * (cosine_max - 1);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), turn = 2 * std::numbers::pi * v;
    const Vec3d z = way / distance, x = glm::normalize(cross(Vec3d{0, 1, 0}, z)), y = cross(z, x);
    const Vec3d ray = sine * (std::cos(turn) * x + std::sin(turn) * y) + cosine * z;
    const double half_chord = std::sqrt(std::max(0.0, radius * radius - distance * distance * sine * sine));
    return {from + (distance * cosine - half_chord) * ray, 0.5 / (std::numbers::pi * (1 - cosine_max))};
}
