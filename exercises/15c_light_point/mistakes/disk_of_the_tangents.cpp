// hint: crowd_at_the_edge
// Even on the disk within the circle in which the tangents touch the light.
#include "raylab/geometry/local_frame.h"
#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double distance = glm::length(center - from), sine_max = radius / distance;
    const double cosine_max = std::sqrt(1 - sine_max * sine_max), turn = 2 * std::numbers::pi * v;
    const double tangent = std::sqrt(u) * sine_max / cosine_max;
    const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
    const LocalFrame frame = frame_around((center - from) / distance);
    const Vec3d ray = frame.to_world({sine * std::cos(turn), sine * std::sin(turn), cosine});
    const double aside = distance * sine, half_chord = std::sqrt(std::max(0.0, radius * radius - aside * aside));
    const Vec3d point = from + (distance * cosine - half_chord) * ray;
    return {point, 1 / (2 * std::numbers::pi * (1 - cosine_max))};
}
