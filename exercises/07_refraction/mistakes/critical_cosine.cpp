// hint: sine_for_cosine
// Compares the cosine with the critical angle's sine.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind, cosine = -dot(direction, normal);
    if (eta > 1 && cosine < 1 / eta) return std::nullopt;
    const Vec3d along = eta * (direction + cosine * normal);
    return along - std::sqrt(1 - dot(along, along)) * normal;
}
