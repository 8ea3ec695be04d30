// hint: too_far
// To be on the safe side a whole cell more.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double leaves = std::numeric_limits<double>::infinity();
    int across = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double ahead = direction[axis] > 0 ? cube.low[axis] + cube.side : cube.low[axis];
        const double t = (ahead - origin[axis]) / direction[axis];
        if (t < leaves) {
            leaves = t;
            across = axis;
        }
    }
    Vec3d point = origin + leaves * direction;
    const double face = direction[across] > 0 ? cube.low[across] + cube.side : cube.low[across];
    point[across] = face + (direction[across] > 0 ? 1.5 : -1.5) * smallest;
    return point;
}
