// hint: tangent_not_unit
// Multiplies the part along the surface, which has the sine before in it, by the sine behind.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double cosine = -dot(direction, normal);
    const double sine = ior_before / ior_behind * std::sqrt(1 - cosine * cosine);
    if (sine > 1) return std::nullopt;
    return sine * (direction + cosine * normal) - std::sqrt(1 - sine * sine) * normal;
}
