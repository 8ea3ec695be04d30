// hint: sine_for_cosine
// Asks for total reflection with an angle measured from the surface, and not from the normal.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const Vec3d across = cross(normal, direction);
    const double from_surface = std::asin(std::fmin(1, -dot(direction, normal)));
    if (ior_before > ior_behind && from_surface < std::asin(ior_behind / ior_before)) return std::nullopt;
    if (glm::length(across) < 1e-12) return -normal;
    const double sine = ior_before / ior_behind * glm::length(across);
    return sine * glm::normalize(cross(across, normal)) - std::sqrt((1 - sine) * (1 + sine)) * normal;
}
