#pragma once

#include "raylab/scene/scene.h"

namespace raylab {

Color color_at(const Checker& checker, const Vec3d& point, const Vec3d& normal);

/// The colour of a pigment at a point of a surface. A checker is projected along the normal's dominant axis, like a
/// polygon: so the coordinate that is constant on the floor, and would be rounded to either side of a cell's edge, is
/// not used.
inline Color color_at(const Pigment& pigment, const Vec3d& point, const Vec3d& normal) {
    if (const auto* plain = std::get_if<Color>(&pigment)) return *plain;
    return color_at(std::get<Checker>(pigment), point, normal);
}

/// Whether it is black everywhere.
bool is_black(const Pigment& pigment);

/// Whether its colour differs from point to point.
bool depends_on_point(const Pigment& pigment);

}  // namespace raylab
