// Each axis's later plane.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    Vec3d leave(std::numeric_limits<double>::infinity());
    for (int i = 0; i < 3; ++i)
        if (direction[i] != 0)
            leave[i] = std::max((cube.low[i] - origin[i]) / direction[i],
                                (cube.low[i] + cube.side - origin[i]) / direction[i]);
    const double t = std::min({leave.x, leave.y, leave.z});
    const int axis = t == leave.x ? 0 : t == leave.y ? 1 : 2;
    Vec3d p = origin + direction * t;
    const double half = 0.5 * smallest;
    p[axis] = direction[axis] < 0 ? cube.low[axis] - half : cube.low[axis] + cube.side + half;
    return p;
}
