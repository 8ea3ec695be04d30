// hint: sine_of_cosine
// The part along the surface is right, and the part across it made of 1 - cosine in place of its square.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind, down = dot(direction, normal);
    const Vec3d along = eta * (direction - down * normal);
    const double rest = 1 - eta * eta * (1 + down);
    if (rest < 0) return std::nullopt;
    return glm::normalize(along - std::sqrt(rest) * normal);
}
