// hint: straight_on
// Lets the ray pass where it is not totally reflected.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double sine = glm::length(cross(direction, normal));
    if (ior_before * sine > ior_behind) return std::nullopt;
    return direction;
}
