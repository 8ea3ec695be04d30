// hint: pdf_of_points_by_area
// One over the area of what is seen, times the squared distance, as if the light were never at a slant.
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double d = glm::length(way), sine_max = radius / d, cosine_max = std::sqrt(1 - sine_max * sine_max);
    const double cosine = cosine_max + (1 - v) * (1 - cosine_max), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double turn = 2 * std::numbers::pi * u;
    const Vec3d ray = frame_around(way / d).to_world({sine * std::cos(turn), sine * std::sin(turn), cosine});
    const double t = d * cosine - std::sqrt(std::max(0.0, radius * radius - d * d * sine * sine));
    const double cap = 2 * std::numbers::pi * radius * radius * (1 - radius / d);
    return {from + t * ray, t * t / cap};
}
