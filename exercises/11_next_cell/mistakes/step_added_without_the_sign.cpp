// hint: wrong_way
// The face has the sign of the direction, and the step that is added to it has none.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <cmath>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3d centre = cube.low + Vec3d(cube.side / 2);
    Vec3d faces = centre, t{std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        faces[axis] += std::copysign(cube.side / 2, direction[axis]);
        if (direction[axis] != 0) t[axis] = (faces[axis] - origin[axis]) / direction[axis];
    }
    const int across = t.x <= t.y ? (t.x <= t.z ? 0 : 2) : (t.y <= t.z ? 1 : 2);
    Vec3d point = origin + t[across] * direction;
    point[across] = faces[across] + smallest / 2;
    return point;
}
