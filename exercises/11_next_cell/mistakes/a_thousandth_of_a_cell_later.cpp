// hint: along_the_ray
// A thousandth of the smallest cell along the ray: seldom too far, and sometimes.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <algorithm>
#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    const Vec3d way = glm::normalize(direction);
    double t = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        if (way[axis] != 0)
            t = std::min(t, ((way[axis] > 0 ? cube.low[axis] + cube.side : cube.low[axis]) - origin[axis]) / way[axis]);
    return origin + t * way + 0.001 * smallest * way;
}
