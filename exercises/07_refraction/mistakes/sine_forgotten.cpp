// hint: tangent_not_unit
// Multiplies a unit vector along the surface by the ratio of the indices.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double cosine = -dot(direction, normal), eta = ior_before / ior_behind;
    const double rest = 1 - eta * eta * (1 - cosine * cosine);
    if (rest < 0) return std::nullopt;
    const Vec3d along = direction + cosine * normal;
    const double sine = glm::length(along);
    if (sine == 0) return direction;
    return eta / sine * along - std::sqrt(rest) * normal;
}
