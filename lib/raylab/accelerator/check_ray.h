#pragma once

#include "raylab/base/error.h"
#include "raylab/geometry/ray.h"

#include <functional>

namespace raylab {

/// Throws an Error unless a ray's numbers are finite (its range may reach from -infinity to +infinity) and its
/// direction is not zero. Every reader of rays calls it; `place` is called only for the message.
void check_ray(const Ray& ray, const std::function<Place()>& place);

}  // namespace raylab
