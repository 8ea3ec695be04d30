// hint: along_the_ray
// How long the way to the exit is, and half of the smallest cell more of it.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const double speed = glm::length(direction);
    double leaves = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double to_low = cube.low[axis] - origin[axis], to_high = to_low + cube.side;
        if (direction[axis] > 0) leaves = std::min(leaves, to_high / direction[axis]);
        if (direction[axis] < 0) leaves = std::min(leaves, to_low / direction[axis]);
    }
    const double way = leaves * speed + smallest / 2;
    return origin + way / speed * direction;
}
