// hint: sideways
// The two cross products in the wrong order give a tangent that leads back.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const Vec3d across = cross(normal, direction);
    const double sine = ior_before / ior_behind * glm::length(across);
    if (sine > 1) return std::nullopt;
    if (glm::length(across) < 1e-12) return -normal;
    const Vec3d tangent = glm::normalize(cross(normal, across));
    return sine * tangent - std::cos(std::asin(sine)) * normal;
}
