#pragma once

#include "raylab/geometry/shapes.h"

// Buildings, made by rule: axis-aligned triangles, long ones beside short ones, whose boxes overlap much. They are
// computed from +, -, *, / and square roots alone: the same bits everywhere. y points up.

namespace raylab {

/// A hall of two storeys along x: arcades of round columns, balusters, pleated curtains, floor tiles, and cornices,
/// rails and purlins as long as the whole hall. 2^levels bays of some 3000 triangles each; its box is 4 * 2^levels
/// long, 12 high and 14 wide, and nothing of it lies outside of its walls but half of its first columns.
Mesh arcade_hall(int levels);

/// Streets along x and z with 4^levels buildings, each with setbacks, cornices and windows on every storey, some of
/// them crowned by thin masts: some 2000 triangles each.
Mesh city(int levels);

}  // namespace raylab
