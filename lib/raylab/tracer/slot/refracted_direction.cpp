#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double cosine = -dot(direction, normal);
    // Its part along the surface: Snell's law.
    const Vec3d along = ior_before / ior_behind * (direction + cosine * normal);
    const double square = 1 - dot(along, along);  // of the cosine behind the surface
    if (!(square >= 0)) return std::nullopt;      // NaN too: indices that leave the doubles
    return glm::normalize(along - std::sqrt(square) * normal);
}
