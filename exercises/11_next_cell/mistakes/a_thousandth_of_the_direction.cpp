// hint: fixed_step
// The exit, and a thousandth of the direction more, for small cells and for large ones.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    Vec3d leave(std::numeric_limits<double>::infinity());
    for (int i = 0; i < 3; ++i)
        if (direction[i] != 0)
            leave[i] = std::max((cube.low[i] - origin[i]) / direction[i],
                                (cube.low[i] + cube.side - origin[i]) / direction[i]);
    const Vec3d exit = origin + direction * std::min({leave.x, leave.y, leave.z});
    return exit + direction * 0.001;
}
