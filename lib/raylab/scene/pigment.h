#pragma once

#include "raylab/scene/scene.h"

namespace raylab {

namespace detail {
Color color_of_cell(const Checker& checker, Vec3d point, Vec3d normal);
}

// Copied number by number: what is passed by its address or copied as a whole is kept in memory, even where the colour is plain.
inline Color color_at(const Checker& checker, const Vec3d& point, const Vec3d& normal) {
    return detail::color_of_cell(checker, {point.x, point.y, point.z}, {normal.x, normal.y, normal.z});
}

/// The colour of a pigment at a point of a surface. A checker is laid on along the normal's dominant axis, as a polygon
/// is projected: never a third coordinate that is constant on the floor and rounded to either side of a cell's edge.
inline Color color_at(const Pigment& pigment, const Vec3d& point, const Vec3d& normal) {
    if (const auto* plain = std::get_if<Color>(&pigment)) return *plain;
    return color_at(std::get<Checker>(pigment), point, normal);
}

/// Whether it is black everywhere.
bool is_black(const Pigment& pigment);

/// Whether it is not the same colour everywhere.
bool depends_on_point(const Pigment& pigment);

}  // namespace raylab
