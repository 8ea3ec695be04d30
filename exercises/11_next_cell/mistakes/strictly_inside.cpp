// hint: last_plane
// or: stays, one_group
// Leaves through the face whose square the ray meets strictly inside: on a border it finds none.
#include "raylab/accelerator/octree/point_in_next_cell.h"

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3d high = cube.low + Vec3d(cube.side);
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double plane = direction[axis] > 0 ? high[axis] : cube.low[axis];
        Vec3d point = origin + ((plane - origin[axis]) / direction[axis]) * direction;
        bool inside = true;
        for (int other = 0; other < 3; ++other)
            inside = inside && (other == axis || (cube.low[other] < point[other] && point[other] < high[other]));
        point[axis] = plane + (direction[axis] > 0 ? 0.5 : -0.5) * smallest;
        if (inside) return point;
    }
    return origin;
}
