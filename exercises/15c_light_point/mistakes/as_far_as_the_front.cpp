// hint: at_one_distance
// Goes along each ray until it is as far as the light's nearest point, which is where only the middle ray ends.
#include "raylab/transport/light/light_point.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d axis = glm::normalize(center - from), front = center - radius * axis;
    const double half_max = std::asin(radius / glm::length(center - from)) / 2, sine_max = std::sin(half_max);
    const double theta = 2 * std::asin(sine_max * std::sqrt(v));
    const auto turn = std::polar(std::sin(theta), 2 * std::numbers::pi * u);
    const Vec3d x = glm::normalize(cross(std::abs(axis.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}, axis));
    const Vec3d ray = turn.imag() * x + turn.real() * cross(axis, x) + std::cos(theta) * axis;
    return {from + glm::distance(from, front) * ray, 1 / (4 * std::numbers::pi * sine_max * sine_max)};
}
