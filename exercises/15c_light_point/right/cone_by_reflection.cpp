#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    // The cone around z is reflected so that z becomes the way to the light's centre.
    const Vec3d way = center - from;
    const double distance = glm::length(way), sine_max = radius / distance;
    const double height = 1 - std::sqrt((1 - sine_max) * (1 + sine_max));
    const double below = height * (1 - u), across = std::sqrt(below * (2 - below));
    const double angle = std::numbers::pi * (1 - 2 * v);
    const Vec3d axis = way / distance, pole{0, 0, axis.z > 0 ? -1.0 : 1.0};
    const Vec3d local{across * std::sin(angle), across * std::cos(angle), pole.z * (1 - below)};
    const Vec3d normal = glm::normalize(pole - axis);
    const Vec3d direction = local - 2 * dot(local, normal) * normal;
    // Where the ray is nearest to the centre, and back from there.
    const double along = dot(way, direction), past = glm::length(way - along * direction);
    const double back = std::sqrt(std::max(0.0, (radius - past) * (radius + past)));
    return {from + (along - back) * direction, 1 / (2 * std::numbers::pi * height)};
}
