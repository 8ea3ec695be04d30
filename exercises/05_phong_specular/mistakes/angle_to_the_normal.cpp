// hint: to_normal
// Asks on which side the light is, and then for the angle between viewer and normal.
#include "raylab/tracer/phong_specular.h"

#include <cmath>
#include <numbers>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    if (dot(normal, to_light) <= 0) return 0;
    const double angle = std::atan2(glm::length(cross(normal, to_viewer)), dot(normal, to_viewer));
    if (angle >= std::numbers::pi / 2) return 0;
    return std::pow(std::cos(angle), shininess);
}
