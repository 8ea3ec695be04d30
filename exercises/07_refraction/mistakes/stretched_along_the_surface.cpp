// hint: tangents_for_sines
// Stretches the part along the surface, keeps the other and makes the sum unit: so the tangents have the ratio.
#include "raylab/tracer/refracted_direction.h"

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double down = dot(direction, normal), eta = ior_before / ior_behind;
    const Vec3d along = direction - down * normal;
    if (eta * glm::length(along) > 1) return std::nullopt;
    return glm::normalize(eta * along + down * normal);
}
