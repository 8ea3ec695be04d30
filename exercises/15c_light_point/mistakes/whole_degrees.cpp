// hint: whole_steps
// The turn around the light's middle is a whole number of degrees.
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double d = glm::length(way), sine_max = radius / d, cosine_max = std::sqrt(1 - sine_max * sine_max);
    const double cosine = cosine_max + (1 - v) * (1 - cosine_max), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double turn = std::numbers::pi / 180 * std::floor(360 * u);
    const Vec3d ray = frame_around(way / d).to_world({sine * std::cos(turn), sine * std::sin(turn), cosine});
    const double t = d * cosine - std::sqrt(std::max(0.0, radius * radius - d * d * sine * sine));
    return {from + t * ray, 0.5 / (std::numbers::pi * (1 - cosine_max))};
}
