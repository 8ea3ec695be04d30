#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A cell of an octree: a cube given by its lowest corner and its side.
struct OctreeCube {
    Vec3d low;
    double side;
};

/// A point inside the cell that a ray enters as it leaves `cube` through a face, whatever the size of that cell: no
/// cell is less than `smallest` wide, and all begin at multiples of their sides. The ray passes through the cube, and
/// its direction is not zero but of any length. This is the slot of exercise 11.
Vec3d point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin, const Vec3d& direction);

}  // namespace raylab
