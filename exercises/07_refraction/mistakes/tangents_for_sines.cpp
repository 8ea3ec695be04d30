// hint: tangents_for_sines
// Snell's law with tangents.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double cosine = -dot(direction, normal);
    const Vec3d along = direction + cosine * normal;
    const double eta = ior_before / ior_behind;
    if (eta * glm::length(along) > 1) return std::nullopt;
    const double tangent = eta * glm::length(along) / cosine;
    if (tangent == 0) return -normal;
    const Vec3d way = tangent * glm::normalize(along) - normal;
    return way / std::sqrt(1 + tangent * tangent);
}
