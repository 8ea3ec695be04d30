#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <optional>

namespace raylab {

/// The smallest t inside ray.range (closed) at which ray.origin + t ray.direction lies on the sphere; absent: no such
/// t. The direction need not be unit; the origin may lie inside. This is the slot of exercise 02.
std::optional<double> nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere);

}  // namespace raylab
