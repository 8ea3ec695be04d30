// hint: origin_beside
// Each t serves to choose the face, and then the origin itself is put beyond that.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <cmath>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3d centre = cube.low + Vec3d(cube.side / 2);
    Vec3d t{std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0)
            t[axis] = (centre[axis] + std::copysign(cube.side / 2, direction[axis]) - origin[axis]) / direction[axis];
    const int across = t.x <= t.y ? (t.x <= t.z ? 0 : 2) : (t.y <= t.z ? 1 : 2);
    const double beyond = centre[across] + std::copysign((cube.side + smallest) / 2, direction[across]);
    return {across == 0 ? beyond : origin.x, across == 1 ? beyond : origin.y, across == 2 ? beyond : origin.z};
}
