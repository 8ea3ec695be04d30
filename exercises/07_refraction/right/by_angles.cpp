// Snell's law as it is written, with angles.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const Vec3d across = cross(normal, cross(direction, normal));  // along the surface, as long as the sine
    const double sine = ior_before / ior_behind * glm::length(across);
    if (sine > 1) return std::nullopt;
    if (sine == 0) return direction;
    const double angle = std::asin(sine);
    return std::sin(angle) * glm::normalize(across) - std::cos(angle) * normal;
}
