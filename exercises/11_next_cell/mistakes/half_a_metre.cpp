// hint: fixed_step
// Half a metre beyond the face, as if the smallest cells were one wide.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    double t = std::numeric_limits<double>::infinity();
    int axis = 0;
    for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0) continue;
        const double face = direction[i] > 0 ? cube.low[i] + cube.side : cube.low[i];
        const double at = (face - origin[i]) / direction[i];
        if (at < t) {
            t = at;
            axis = i;
        }
    }
    Vec3d p = origin + t * direction;
    p[axis] += direction[axis] > 0 ? 0.5 : -0.5;
    return p;
}
