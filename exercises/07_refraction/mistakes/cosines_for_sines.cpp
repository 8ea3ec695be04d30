// hint: sine_for_cosine
// Snell's law with the cosines.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double before = -dot(direction, normal), behind = ior_before / ior_behind * before;
    if (behind > 1) return std::nullopt;
    const Vec3d along = direction + before * normal;
    const double sine = glm::length(along);
    if (sine < 1e-9) return -normal;
    return std::sqrt(1 - behind * behind) / sine * along - behind * normal;
}
