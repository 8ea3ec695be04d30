#pragma once

#include "raylab/geometry/box.h"

namespace raylab {

/// A box about what of a triangle lies inside a box, surely; empty where nothing does. (Havran and Bittner, On
/// Improving KD-Trees for Ray Shooting, WSCG 2002: "split clipping".)
Box clipped_bounds(const Triangle& triangle, const Box& inside);

/// What two boxes share; is_empty() where it is nothing.
Box intersection(const Box& a, const Box& b);

}  // namespace raylab
