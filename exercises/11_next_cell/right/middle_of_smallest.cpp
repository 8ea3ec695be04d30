// In whole numbers of smallest cells: the middle of the one beyond the face.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const double infinity = std::numeric_limits<double>::infinity();
    double exit = infinity;
    Vec3d reached{infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const double far = direction[axis] < 0 ? cube.low[axis] : cube.low[axis] + cube.side;
        if (direction[axis] != 0) reached[axis] = (far - origin[axis]) / direction[axis];
        exit = std::min(exit, reached[axis]);
    }
    Vec3d point = origin + exit * direction;
    bool crossed = false;
    for (int axis = 0; axis < 3; ++axis) {
        double number = std::floor(point[axis] / smallest);
        if (reached[axis] == exit && !crossed) {
            crossed = true;
            const double far = direction[axis] < 0 ? cube.low[axis] - smallest : cube.low[axis] + cube.side;
            number = std::round(far / smallest);
        }
        point[axis] = (number + 0.5) * smallest;
    }
    return point;
}
