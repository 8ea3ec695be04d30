#pragma once

#include "raylab/geometry/shapes.h"

// Meshes whose triangles differ much in size or shape, made by rule from +, -, *, / and square roots alone: the same
// bits everywhere.

namespace raylab {

/// A sphere with 64 * 2^levels hairs, each a flat ribbon of 16 triangles a thousandth as wide as the hair is long; half
/// of the hairs hang straight in one or two triangles.
Mesh hair(int levels);

/// A stadium of long steps 240 across, with a bumpy sphere of radius 1/4 and 20 * 4^levels triangles in its middle.
Mesh stadium(int levels);

}  // namespace raylab
