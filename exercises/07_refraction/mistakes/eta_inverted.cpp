// hint: eta_inverted
// Takes the ratio of the indices the other way round.
// It shows in the traced scene.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_behind / ior_before;
    const double cosine = -dot(direction, normal);
    const double square = 1 - eta * eta * (1 - cosine * cosine);
    if (square < 0) return std::nullopt;
    return eta * direction + (eta * cosine - std::sqrt(square)) * normal;
}
