// hint: clamped
// The absolute value under the root, so that it is never a root of what is negative.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind, c = -dot(direction, normal);
    const double square = 1 - eta * eta * (1 - c * c);
    return eta * direction + (eta * c - std::sqrt(std::abs(square))) * normal;
}
