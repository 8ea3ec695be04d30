#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>

namespace raylab {

/// Some unit vector perpendicular to an axis, which may have any length but zero.
inline Vec3d perpendicular_to(const Vec3d& axis) {
    const Vec3d other = std::abs(axis.x) < 0.6 * glm::length(axis) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    return glm::normalize(cross(axis, other));
}

}  // namespace raylab
