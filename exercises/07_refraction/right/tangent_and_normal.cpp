// What lies along the surface, and the rest.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const Vec3d along = (direction - dot(direction, normal) * normal) * (ior_before / ior_behind);
    const double rest = 1 - dot(along, along);
    if (rest < 0) return std::nullopt;
    return along - std::sqrt(rest) * normal;
}
