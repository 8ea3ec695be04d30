#pragma once

#include "raylab/geometry/vector.h"

#include <functional>
#include <optional>

namespace raylab {

/// A function that finds the nearest hit: the t > 0 of it at origin + t direction, the direction of any length but
/// zero. Absent: nothing is hit.
using FirstHit = std::function<std::optional<double>(const Vec3d& origin, const Vec3d& direction)>;

/// Whether a surface keeps the light (a position) from a point: something opaque is between them, or the light is
/// behind the surface itself. The point lies on the surface up to rounding; `normal` is unit and on the side that is
/// looked at. A surface that the light sits on hides nothing. This is the slot of exercise 06.
bool in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit);

}  // namespace raylab
