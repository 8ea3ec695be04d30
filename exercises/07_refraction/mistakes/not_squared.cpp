// hint: not_squared
// Forgets to square the ratio of the indices.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind;
    const double cosine = -dot(direction, normal);
    const double square = 1 - eta * (1 - cosine * cosine);
    if (square < 0) return std::nullopt;
    return eta * direction + (eta * cosine - std::sqrt(square)) * normal;
}
