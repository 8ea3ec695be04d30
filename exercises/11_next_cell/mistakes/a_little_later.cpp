// hint: along_the_ray
// The exit's t and a little more: a hundredth of the smallest cell further along the ray.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double leaves = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double low = (cube.low[axis] - origin[axis]) / direction[axis];
        const double high = (cube.low[axis] + cube.side - origin[axis]) / direction[axis];
        leaves = std::min(leaves, std::max(low, high));
    }
    const double little = 0.01 * smallest / glm::length(direction);
    return origin + (leaves + little) * direction;
}
