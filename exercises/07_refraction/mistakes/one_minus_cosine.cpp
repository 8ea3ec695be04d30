// hint: sine_of_cosine
// 1 - cosine for the square of the sine.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind, cosine = -dot(direction, normal);
    const double square_behind = eta * eta * (1 - cosine);
    if (square_behind > 1) return std::nullopt;
    return glm::normalize(eta * direction + (eta * cosine - std::sqrt(1 - square_behind)) * normal);
}
