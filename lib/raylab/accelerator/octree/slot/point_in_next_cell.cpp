#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double t = std::numeric_limits<double>::infinity();
    int across = 0;  // the axis across which the ray leaves
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
    // Along the other axes the point is kept inside the cube, whatever the rounding. The upper face belongs to the next
    // cell; half the smallest cell before it, the point is still in the same cell.
    const double inside = cube.side - smallest / 2;
    for (int axis = 0; axis < 3; ++axis) point[axis] = std::clamp(point[axis], cube.low[axis], cube.low[axis] + inside);
    // Half the smallest cell beyond the face (Glassner 1984): that is inside the next cell, however small it is.
    point[across] =
        direction[across] > 0 ? cube.low[across] + cube.side + smallest / 2 : cube.low[across] - smallest / 2;
    return point;
}
