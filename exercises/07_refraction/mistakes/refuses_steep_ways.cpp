// hint: refracts_too_little
// Takes all that leaves at more than 45 degrees from the normal's line for reflected.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind, cosine = -dot(direction, normal);
    const double square = 1 - eta * eta * (1 - cosine * cosine);
    if (square < 0.5) return std::nullopt;
    return eta * direction + (eta * cosine - std::sqrt(square)) * normal;
}
