// hint: pdf_of_all_directions
// Turns a cone around z to the light by a reflection, and keeps the density of directions all around.
#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from, axis = glm::normalize(way), pole{0, 0, axis.z > 0 ? -1.0 : 1.0};
    const double squared = dot(way, way), below = v * (1 - std::sqrt(1 - radius * radius / squared));
    const double across = std::sqrt(below * (2 - below)), turn = 2 * std::numbers::pi * u;
    const Vec3d local{across * std::cos(turn), across * std::sin(turn), pole.z * (1 - below)};
    const Vec3d ray = glm::reflect(local, glm::normalize(pole - axis));
    const double along = dot(way, ray), under = along * along - squared + radius * radius;
    return {from + (along - std::sqrt(std::max(0.0, under))) * ray, 1 / (4 * std::numbers::pi)};
}
