// hint: small_is_not_zero
// Takes a direction's coordinate below a billionth for none at all.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <cmath>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    int first = 0;
    double least = 1e30, face = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis]) < 1e-9) continue;
        const double plane = direction[axis] > 0 ? cube.low[axis] + cube.side : cube.low[axis];
        const double t = (plane - origin[axis]) / direction[axis];
        if (t >= least) continue;
        least = t;
        first = axis;
        face = plane;
    }
    Vec3d point = origin + least * direction;
    point[first] = face + std::copysign(smallest / 2, direction[first]);
    return point;
}
