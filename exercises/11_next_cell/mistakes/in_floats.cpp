// hint: floats
// Half the smallest cell beyond the face, and the place on it in floats.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3f o = convert<float>(origin), d = convert<float>(direction);
    float t = std::numeric_limits<float>::infinity();
    int across = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (d[axis] == 0) continue;
        const float plane = cast<float>(d[axis] > 0 ? cube.low[axis] + cube.side : cube.low[axis]);
        const float reached = (plane - o[axis]) / d[axis];
        if (reached < t) {
            t = reached;
            across = axis;
        }
    }
    Vec3d point = convert<double>(o + t * d);
    point[across] = d[across] > 0 ? cube.low[across] + cube.side + smallest / 2 : cube.low[across] - smallest / 2;
    return point;
}
