#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    // Pharr, Jakob and Humphreys, Physically Based Rendering (4th edition), 6.2.4: the angle at the light's centre
    // belongs to the angle at the lit point, and no ray is needed.
    const double distance = glm::length(center - from), sine_max = radius / distance;
    const double squared_max = sine_max * sine_max, below_max = squared_max / (1 + std::sqrt(1 - squared_max));
    const double below = below_max * v, cosine = 1 - below, squared = below * (2 - below);
    const double at_center = squared / sine_max + cosine * std::sqrt(std::max(0.0, 1 - squared / squared_max));
    const double across = std::sqrt(std::max(0.0, 1 - at_center * at_center)), angle = 2 * std::numbers::pi * u;
    const LocalFrame frame = frame_around((from - center) / distance);
    const Vec3d normal = frame.to_world({across * std::cos(angle), across * std::sin(angle), at_center});
    return {center + radius * normal, 1 / (2 * std::numbers::pi * below_max)};
}
