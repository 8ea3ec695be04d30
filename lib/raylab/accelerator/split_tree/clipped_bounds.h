#pragma once

#include "raylab/geometry/bounds/box.h"

namespace raylab {

/// A box that surely encloses the part of a triangle inside a box; empty where there is none. (Havran and Bittner, On
/// Improving KD-Trees for Ray Shooting, WSCG 2002: "split clipping".)
Box clipped_bounds(const Triangle& triangle, const Box& inside);

/// The intersection of two boxes; is_empty() where they are disjoint.
Box intersection(const Box& a, const Box& b);

}  // namespace raylab
