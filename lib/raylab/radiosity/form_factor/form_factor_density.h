#pragma once

#include "raylab/geometry/vector.h"

#include <numbers>

namespace raylab {

/// The form factor from a point to the neighbourhood of another, for each m^2 there: cos cos / (pi r^2). The normals
/// have length 1. It is zero where either point is not in front of the other, and where both are one.
inline double form_factor_density(const Vec3d& from, const Vec3d& normal, const Vec3d& to, const Vec3d& normal_to) {
    const Vec3d way = to - from;
    const double squared = dot(way, way), leaves = dot(normal, way), arrives = -dot(normal_to, way);
    return leaves > 0 && arrives > 0 ? leaves * arrives / (std::numbers::pi * squared * squared) : 0;
}

}  // namespace raylab
