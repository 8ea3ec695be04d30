// hint: step_by_direction
// or: along_the_ray
// Adds half of the smallest cell to t, which counts lengths of the direction.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0)
            leave = std::min(leave,
                             (cube.low[axis] + (direction[axis] > 0 ? cube.side : 0) - origin[axis]) / direction[axis]);
    return origin + (leave + smallest / 2) * direction;
}
