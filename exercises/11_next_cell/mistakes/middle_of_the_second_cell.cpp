// hint: too_far
// Counts the face in smallest cells, and takes the middle of the second one beyond it.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <cmath>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3d high = cube.low + Vec3d(cube.side);
    Vec3d t{std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0)
            t[axis] = ((direction[axis] < 0 ? cube.low : high)[axis] - origin[axis]) / direction[axis];
    const int across = t.x <= t.y && t.x <= t.z ? 0 : t.y <= t.z ? 1 : 2;
    Vec3d point = origin + t[across] * direction;
    const bool down = direction[across] < 0;
    const double number = std::round((down ? cube.low : high)[across] / smallest) + (down ? -2 : 1);
    point[across] = (number + 0.5) * smallest;
    return point;
}
