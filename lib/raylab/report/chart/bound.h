#pragma once

#include "raylab/accelerator/outline.h"
#include "raylab/geometry/ray.h"

#include <optional>
#include <string>

// What drawings and diagrams ask of bounds. For the eye: nothing here decides anything.

namespace raylab {

/// Whether two are the same numbers.
bool same(const Bound& a, const Bound& b);

/// Where a ray is inside, about; absent: nowhere in its range.
std::optional<Interval<double>> span_inside(const Ray& ray, const Bound& bound);

/// The axis-aligned box about a bound.
Box box_about(const Bound& bound);

/// "x 0..1, y -2..3, z 0..0.5", "center (0, 0, 0), radius 2".
std::string words(const Bound& bound);

}  // namespace raylab
