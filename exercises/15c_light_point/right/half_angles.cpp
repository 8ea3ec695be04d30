#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    // 1 - cos is twice the squared sine of half the angle: its root, the sine of half the angle, is like a lens'
    // radius.
    const Vec3d way = center - from, axis = glm::normalize(way);
    const double half_max = std::asin(radius / glm::length(way)) / 2, sine_max = std::sin(half_max);
    const double theta = 2 * std::asin(sine_max * std::sqrt(v));
    const auto turn = std::polar(std::sin(theta), 2 * std::numbers::pi * (1 - u));
    const Vec3d x = glm::normalize(cross(std::abs(axis.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}, axis));
    const Vec3d direction = turn.imag() * x + turn.real() * cross(axis, x) + std::cos(theta) * axis;
    const double along = dot(way, direction), past = glm::length(way - along * direction);
    const double back = std::sqrt(std::max(0.0, (radius - past) * (radius + past)));
    return {from + (along - back) * direction, 1 / (4 * std::numbers::pi * sine_max * sine_max)};
}
