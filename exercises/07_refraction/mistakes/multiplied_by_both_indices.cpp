// hint: not_unit_length
// The formula without a fraction, multiplied by the index behind, which the result is not divided by at the end.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double cosine = -dot(direction, normal), part = ior_before * cosine;
    const double square = ior_behind * ior_behind - ior_before * ior_before * (1 - cosine * cosine);
    if (square < 0) return std::nullopt;
    return ior_before * direction + (part - std::sqrt(square)) * normal;
}
