#pragma once

#include "raylab/geometry/ray.h"

#include <optional>

namespace raylab {

/// The smallest t of the ray's range at which it is in the closed box from `low` to `high`; absent: at none. This is
/// the slot of exercise 09.
std::optional<double> box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high);

}  // namespace raylab
