// hint: forward_only
// Takes the upper faces for the far ones, whichever way the ray goes.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double t = std::numeric_limits<double>::infinity();
    int across = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double plane = cube.low[axis] + cube.side;
        const double reached = (plane - origin[axis]) / direction[axis];
        if (reached < t) {
            t = reached;
            across = axis;
        }
    }
    Vec3d point = origin + t * direction;
    point[across] =
        direction[across] > 0 ? cube.low[across] + cube.side + smallest / 2 : cube.low[across] - smallest / 2;
    return point;
}
