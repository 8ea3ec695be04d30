// hint: fixed_step
// A millionth beyond the face, whatever the cells.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    int first = 0;
    double least = std::numeric_limits<double>::infinity(), beyond = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = direction[axis];
        if (way == 0) continue;
        const double t = (cube.low[axis] + (way > 0 ? cube.side : 0) - origin[axis]) / way;
        if (t >= least) continue;
        least = t;
        first = axis;
        beyond = way > 0 ? cube.low[axis] + cube.side + 1e-6 : cube.low[axis] - 1e-6;
    }
    Vec3d point = origin + least * direction;
    point[first] = beyond;
    return point;
}
