// hint: eta_inverted
// The smaller index over the larger one, on whichever side the ray is.
#include "raylab/tracer/refracted_direction.h"

#include <algorithm>
#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = std::min(ior_before, ior_behind) / std::max(ior_before, ior_behind);
    const double cosine = -dot(direction, normal);
    const double rest = 1 - eta * eta * (1 - cosine * cosine);
    if (!(rest >= 0)) return std::nullopt;
    return eta * direction + (eta * cosine - std::sqrt(rest)) * normal;
}
