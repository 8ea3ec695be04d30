// hint: last_plane
// Leaves across the axis of the direction's largest component, and keeps the point on that face.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3d sizes = glm::abs(direction);
    const int across = sizes.x >= sizes.y && sizes.x >= sizes.z ? 0 : sizes.y >= sizes.z ? 1 : 2;
    const double sign = direction[across] > 0 ? 1 : -1;
    const Vec3d high = cube.low + Vec3d(cube.side, cube.side, cube.side);
    const double face = sign > 0 ? high[across] : cube.low[across];
    const Vec3d there = origin + (face - origin[across]) / direction[across] * direction;
    Vec3d point = glm::min(glm::max(there, cube.low), high);
    point[across] = face + sign * smallest / 2;
    return point;
}
