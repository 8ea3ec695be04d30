// hint: all_axes
// Steps on across all three axes: to the cell beyond the corner.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <cmath>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double t = std::numeric_limits<double>::infinity();
    int across = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double plane = direction[axis] > 0 ? cube.low[axis] + cube.side : cube.low[axis];
        const double reached = (plane - origin[axis]) / direction[axis];
        if (reached < t) {
            t = reached;
            across = axis;
        }
    }
    Vec3d point = origin + t * direction;
    for (int axis = 0; axis < 3; ++axis)
        point[axis] += std::copysign(smallest, direction[axis]) * (axis == across ? 0.5 : 1);
    return point;
}
