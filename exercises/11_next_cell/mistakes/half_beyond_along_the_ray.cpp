// hint: along_the_ray
// Goes on along the ray until it is half a smallest cell beyond the face: past other sides, where the ray is slanted.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double exit = std::numeric_limits<double>::infinity(), later = exit;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double sign = direction[axis] > 0 ? 1 : -1;
        const double face = cube.low[axis] + (sign > 0 ? cube.side : 0);
        const double t = (face - origin[axis]) / direction[axis];
        if (t > exit) continue;
        exit = t;
        later = (face + sign * smallest / 2 - origin[axis]) / direction[axis];
    }
    return origin + later * direction;
}
