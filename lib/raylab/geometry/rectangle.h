#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>
#include <span>

namespace raylab {

/// Whether a polygon's corners are those of a rectangle, up to the rounding of scenes to floats: a millionth of its
/// size.
inline bool is_rectangle(std::span<const Vec3d> corners) {
    if (corners.size() != 4) return false;
    constexpr double rounding = 1e-6;
    const Vec3d first = corners[1] - corners[0], second = corners[3] - corners[0];
    const double width = glm::length(first), height = glm::length(second);
    return glm::length(corners[0] + first + second - corners[2]) <= rounding * (width + height) &&
           std::abs(dot(first, second)) <= rounding * width * height;
}

}  // namespace raylab
