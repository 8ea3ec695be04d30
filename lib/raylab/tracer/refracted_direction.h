#pragma once

#include "raylab/geometry/vector.h"

#include <optional>

namespace raylab {

/// The direction in which a ray goes on behind a surface between two media, by Snell's law: the unit direction; absent:
/// total internal reflection. `direction` is unit; `normal` is unit and points to the side the ray comes from;
/// `ior_before` and `ior_behind` are the indices of refraction on that side and on the other. This is the slot of
/// exercise 07.
std::optional<Vec3d> refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                         double ior_behind);

}  // namespace raylab
