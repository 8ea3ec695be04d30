// hint: tangent_not_unit
// The tangent by two cross products is as long as the sine before, and is multiplied by the sine behind as it is.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const Vec3d across = cross(normal, direction), tangent = cross(across, normal);
    const double sine = ior_before / ior_behind * glm::length(across);
    if (sine > 1) return std::nullopt;
    return sine * tangent - std::sqrt((1 - sine) * (1 + sine)) * normal;
}
