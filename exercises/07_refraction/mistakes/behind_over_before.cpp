// hint: eta_inverted
// The indices the other way round.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double n = ior_behind / ior_before, cosI = -dot(normal, direction), sinT2 = n * n * (1.0 - cosI * cosI);
    if (sinT2 > 1.0) return std::nullopt;
    return n * direction + (n * cosI - std::sqrt(1.0 - sinT2)) * normal;
}
