// hint: step_by_direction
// Goes across the face by half a smallest cell times the direction's component, not its sign.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    int across = 0;
    double t = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double ahead = cube.low[axis] + (direction[axis] > 0 ? cube.side : 0);
        if (const double at = (ahead - origin[axis]) / direction[axis]; at < t) t = at, across = axis;
    }
    Vec3d point = glm::clamp(origin + t * direction, cube.low, cube.low + cube.side);
    point[across] += direction[across] * smallest / 2;
    return point;
}
