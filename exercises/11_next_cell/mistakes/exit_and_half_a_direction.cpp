// hint: step_by_direction
// or: along_the_ray
// The exit, and from there half of the smallest cell times the direction, whatever its length.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const auto leaves = [&](int axis) {
        const double o = origin[axis], d = direction[axis];
        if (d == 0) return std::numeric_limits<double>::infinity();
        return std::max((cube.low[axis] - o) / d, (cube.low[axis] + cube.side - o) / d);
    };
    Vec3d point = origin + std::min({leaves(0), leaves(1), leaves(2)}) * direction;
    point += 0.5 * smallest * direction;
    return point;
}
