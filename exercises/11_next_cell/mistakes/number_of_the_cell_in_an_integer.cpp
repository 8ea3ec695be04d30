// hint: cut_towards_zero
// or: all_axes
// Numbers of smallest cells are integers: the cast cuts them, and below 0 that is the cell above.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const double infinity = std::numeric_limits<double>::infinity();
    Vec3d far = cube.low, reached{infinity};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] > 0) far[axis] += cube.side;
        if (direction[axis] != 0) reached[axis] = (far[axis] - origin[axis]) / direction[axis];
    }
    const double exit = std::min({reached.x, reached.y, reached.z});
    const int across = exit == reached.x ? 0 : exit == reached.y ? 1 : 2;
    Vec3d point = origin + exit * direction;
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = static_cast<long long>(point[axis] / smallest);
        point[axis] = (static_cast<double>(number) + 0.5) * smallest;
    }
    point[across] = far[across] + (direction[across] > 0 ? 0.5 : -0.5) * smallest;
    return point;
}
