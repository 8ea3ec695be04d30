// hint: origin_beside
// Moves the origin across the face along one axis, and leaves it where it is along the others.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    Vec3d point = origin;
    double first = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double sign = direction[axis] > 0 ? 1 : -1, face = cube.low[axis] + (sign > 0 ? cube.side : 0);
        const double t = (face - origin[axis]) / direction[axis];
        if (t > first) continue;
        first = t;
        point = origin;
        point[axis] = face + sign * smallest / 2;
    }
    return point;
}
