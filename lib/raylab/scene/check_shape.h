#pragma once

#include "raylab/base/error.h"
#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <span>

namespace raylab {

/// Error unless the shape is one: sizes above zero, an axis of some length, vertices that span an area, as floats.
/// What a reader calls once the numbers are in place.
void check_shape(const Shape& shape, const Place& place);

/// Error unless the map is finite and can be undone, exactly.
void check_placement(const Affine& placement, const Place& place);

/// Whether the exact Newell normal of the vertices is zero: they span no area.
bool spans_no_area(std::span<const Vec3f> vertices);

}  // namespace raylab
