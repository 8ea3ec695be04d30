#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>

namespace raylab {

/// The solid angle in which a triangle is seen from the origin, in steradians, at most 2 pi (Van Oosterom and Strackee,
/// "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng. 30, 1983). By the triangle's own sides, so that far
/// away nothing cancels but in the sides themselves: the relative error is that of their lengths.
inline double triangle_solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double volume = std::abs(dot(a, cross(b - a, c - a)));  // six times that of the tetrahedron
    const double to_a = glm::length(a), to_b = glm::length(b), to_c = glm::length(c);
    return 2 * std::atan2(volume, to_a * to_b * to_c + dot(a, b) * to_c + dot(b, c) * to_a + dot(c, a) * to_b);
}

}  // namespace raylab
