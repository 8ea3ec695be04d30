// hint: all_axes
// Adds a vector to the exit, with half of the smallest cell in each of its components.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    Vec3d leave(std::numeric_limits<double>::infinity()), step(-smallest / 2);
    for (int i = 0; i < 3; ++i) {
        if (direction[i] > 0) step[i] = smallest / 2;
        if (direction[i] != 0)
            leave[i] = std::max((cube.low[i] - origin[i]) / direction[i],
                                (cube.low[i] + cube.side - origin[i]) / direction[i]);
    }
    const double t = std::min({leave.x, leave.y, leave.z});
    return origin + t * direction + step;
}
