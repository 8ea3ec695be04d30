// hint: mirrors
// or: clamped
// The mirror direction where all is reflected.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double n = ior_before / ior_behind, c = -dot(normal, direction), k = 1 - n * n * (1 - c * c);
    if (k < 0) return direction + 2 * c * normal;
    return n * direction + (n * c - std::sqrt(k)) * normal;
}
