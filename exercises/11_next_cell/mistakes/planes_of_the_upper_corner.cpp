// hint: forward_only
// Leaves by the first of the three planes through the upper corner, and steps by the sign of the direction.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3d way = cube.low + Vec3d(cube.side) - origin;
    std::vector<std::pair<double, int>> reached;
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0) reached.emplace_back(way[axis] / direction[axis], axis);
    const auto [t, axis] = *std::min_element(reached.begin(), reached.end());
    Vec3d point = origin + t * direction;
    point[axis] = cube.low[axis] + cube.side / 2 + std::copysign(cube.side / 2 + smallest / 2, direction[axis]);
    return point;
}
