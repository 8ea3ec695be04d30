#pragma once

#include "raylab/geometry/vector.h"

#include <array>

namespace raylab {

/// The unit normal of a placed surface: `normal` (not zero, of any length) is its normal before, and the placement's
/// linear part, which is not singular, carries x to columns[0] x.x + columns[1] x.y + columns[2] x.z. It points to the
/// side of the surface to which `normal` did, under mirrors too. This is the slot of exercise 04.
Vec3d transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal);

}  // namespace raylab
