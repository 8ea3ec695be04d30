// hint: root_forgotten
// The square of the cosine.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double n = ior_before / ior_behind, c = -dot(normal, direction), cos2 = 1 - n * n * (1 - c * c);
    if (cos2 < 0) return std::nullopt;
    return n * direction + (n * c - cos2) * normal;
}
