// hint: fixed_step
// A thousandth on along the ray, whatever the size of the cells.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    double t = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double plane = direction[axis] > 0 ? cube.low[axis] + cube.side : cube.low[axis];
        t = std::min(t, (plane - origin[axis]) / direction[axis]);
    }
    return origin + (t + 0.001) * direction;
}
