// hint: from_the_middle
// The middle of the neighbour as large as this cell: the face is right, the place on it is not.
#include "raylab/accelerator/octree/point_in_next_cell.h"

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
    Vec3d point = cube.low + Vec3d(cube.side / 2);
    point[across] =
        direction[across] > 0 ? cube.low[across] + cube.side + smallest / 2 : cube.low[across] - smallest / 2;
    return point;
}
