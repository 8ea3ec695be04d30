#pragma once

#include "raylab/accelerator/outline.h"
#include "raylab/geometry/ray.h"

#include <optional>
#include <string>

// Properties of bounds for drawings and diagrams. They are for the eye: they ignore rounding, and no decision depends
// on them.

namespace raylab {

/// Whether two bounds consist of the same numbers.
bool same(const Bound& a, const Bound& b);

/// Approximately the t at which a ray is inside a bound; absent where that is nowhere in its range.
std::optional<Interval<double>> span_inside(const Ray& ray, const Bound& bound);

/// The axis-aligned box that encloses a bound.
Box box_about(const Bound& bound);

/// "x 0..1, y -2..3, z 0..0.5", "center (0, 0, 0), radius 2".
std::string words(const Bound& bound);

}  // namespace raylab
