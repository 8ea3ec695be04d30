// hint: diameter
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double size = radius + radius, distance = glm::length(center - from);
    const LocalFrame frame = frame_around((from - center) / distance);
    const double lowest = size < distance ? size / distance : 0, phi = 2 * std::numbers::pi * v;
    const double cosine = lowest + (1 - lowest) * u, sine = std::sqrt(1 - cosine * cosine);
    const Vec3d normal = frame.to_world({sine * std::cos(phi), sine * std::sin(phi), cosine});
    const double edge = std::sqrt(1 - lowest * lowest);
    return {center + size * normal, 1 / (2 * std::numbers::pi * (1 - edge))};
}
