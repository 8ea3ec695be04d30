// hint: clamped
// Never less than 0 under the root.
#include "raylab/tracer/refracted_direction.h"

#include <algorithm>
#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double n = ior_before / ior_behind, c = -dot(normal, direction);
    const double k = std::max(0.0, 1 - n * n * (1 - c * c));
    return glm::normalize(n * direction + (n * c - std::sqrt(k)) * normal);
}
