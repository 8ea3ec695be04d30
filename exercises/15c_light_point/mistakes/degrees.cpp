// hint: degrees
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double distance = glm::length(way);
    const double cosine_max = std::sqrt(1 - radius * radius / (distance * distance));
    const double cosine = 1 - u * (1 - cosine_max), sine = std::sqrt(1 - cosine * cosine);
    const double angle = 360 * v;
    const Vec3d local{sine * std::cos(angle), sine * std::sin(angle), cosine};
    const Vec3d direction = frame_around(way / distance).to_world(local);
    const double half_chord = std::sqrt(std::max(0.0, radius * radius - distance * distance * sine * sine));
    const double t = distance * cosine - half_chord;
    return {from + t * direction, 1 / (2 * std::numbers::pi * (1 - cosine_max))};
}
