#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    // Everything in radii, and the lit point on the z axis of a unit sphere: lit point, centre and point are a
    // triangle, whose cosine theorem gives the distance.
    const double away = glm::length(from - center) / radius, squared = 1 / (away * away);
    const double height = squared / (1 + std::sqrt(1 - squared)), below = height * u;
    const double cosine = 1 - below, sine_squared = below * (2 - below);
    const double distance = away * cosine - std::sqrt(std::max(0.0, 1 - away * away * sine_squared));
    const double across = distance * std::sqrt(sine_squared), angle = 2 * std::numbers::pi * v;
    const LocalFrame frame = frame_around((from - center) / (away * radius));
    const Vec3d local{across * std::cos(angle), across * std::sin(angle), away - distance * cosine};
    return {center + radius * frame.to_world(local), 1 / (2 * std::numbers::pi * height)};
}
