// hint: total_reflection_forgotten
// or: not_a_number
// Does not ask for total reflection.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double n = ior_before / ior_behind, cosI = -dot(normal, direction), sinT2 = n * n * (1.0 - cosI * cosI);
    return n * direction + (n * cosI - std::sqrt(1.0 - sinT2)) * normal;
}
