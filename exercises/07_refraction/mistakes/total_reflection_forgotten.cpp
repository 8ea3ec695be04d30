// hint: total_reflection_forgotten
// Takes the root of whatever is there.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const double eta = ior_before / ior_behind;
    const double cosine = -dot(direction, normal);
    return eta * direction + (eta * cosine - std::sqrt(1 - eta * eta * (1 - cosine * cosine))) * normal;
}
