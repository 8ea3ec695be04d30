// hint: mirrored
// Finds the angle at the light's centre, and lays it off from the way on, away from the lit point.
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
    const double t = d * cosine - std::sqrt(std::max(0.0, radius * radius - d * d * sine * sine));
    const double height = std::clamp((d - t * cosine) / radius, -1.0, 1.0), aside = std::sqrt(1 - height * height);
    const LocalFrame frame = frame_around(way / d);
    const Vec3d normal = frame.to_world({aside * std::cos(turn), aside * std::sin(turn), height});
    return {center + radius * normal, 0.5 / (std::numbers::pi * (1 - cosine_max))};
}
