// The library of vectors knows it.
#include "raylab/tracer/refracted_direction.h"

#include <glm/geometric.hpp>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind;
    const Vec3d out = glm::refract(direction, normal, eta);
    if (dot(out, out) < 0.25) return std::nullopt;
    return out;
}
