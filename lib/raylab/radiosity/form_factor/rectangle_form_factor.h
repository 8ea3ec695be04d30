#pragma once

#include "raylab/geometry/vector.h"

#include <optional>
#include <span>

namespace raylab {

/// The form factor between two rectangles in closed form, if all of their edges are parallel to three axes at right
/// angles: parallel rectangles (C-13 of Howell's catalogue; C-11 where they are equal and opposite) or perpendicular
/// ones (the sum of which C-14 and C-15 are special cases), anywhere; only what is in front of the other's plane
/// counts. Absent for all other polygons, and where the sum's terms cancel to fewer than twelve digits.
std::optional<double> rectangle_form_factor(std::span<const Vec3d> from, std::span<const Vec3d> to);

}  // namespace raylab
