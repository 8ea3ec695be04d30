// hint: zero_vector
// Under total internal reflection the zero vector, as in shading languages.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind, cosine = -dot(direction, normal);
    const double inner = 1 - eta * eta * (1 - cosine * cosine);
    if (inner < 0) return Vec3d{0, 0, 0};
    return eta * direction + (eta * cosine - std::sqrt(inner)) * normal;
}
