#pragma once

#include "raylab/base/error.h"
#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <span>

namespace raylab {

/// Throws an Error unless the shape is valid, as floats: sizes are above zero, an axis has a length, vertices span an
/// area. A reader calls it once the numbers are in place.
void check_shape(const Shape& shape, const Place& place);

/// Throws an Error unless the transform is finite and invertible, exactly.
void check_placement(const Affine& placement, const Place& place);

/// The same of a motion, at all of these times.
void check_motion(const Affine& placement, const Motion& motion, const Interval<float>& times, const Place& place);

/// Whether the exact Newell normal of the vertices is zero: they span no area.
bool spans_no_area(std::span<const Vec3f> vertices);

}  // namespace raylab
