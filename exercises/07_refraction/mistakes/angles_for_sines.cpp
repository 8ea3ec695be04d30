// hint: angles_for_sines
// Multiplies the angle by the ratio of the indices, not its sine.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double angle = std::acos(std::fmin(1, -dot(direction, normal)));
    const double behind = ior_before / ior_behind * angle;
    if (std::cos(behind) < 0) return std::nullopt;
    const Vec3d along = direction - dot(direction, normal) * normal;
    if (glm::length(along) < 1e-12) return -normal;
    return std::sin(behind) * glm::normalize(along) - std::cos(behind) * normal;
}
