// hint: not_unit_length
// By wave vectors, which are as long as the index.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const Vec3d wave = ior_before * direction;
    const double across = dot(wave, normal);
    const Vec3d along = wave - across * normal;
    const double square = ior_behind * ior_behind - dot(along, along);
    if (square < 0) return std::nullopt;
    return along - std::sqrt(square) * normal;
}
