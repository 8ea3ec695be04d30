// Along the surface both waves keep step: n1 D and n2 T have the same part there.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const Vec3d wave = ior_before * direction;
    const Vec3d along = wave - dot(wave, normal) * normal;
    const double square = ior_behind * ior_behind - dot(along, along);
    if (square < 0) return std::nullopt;
    return glm::normalize(along - std::sqrt(square) * normal);
}
