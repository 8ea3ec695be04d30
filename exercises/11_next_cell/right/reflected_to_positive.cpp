// All directions made positive first.
#include "raylab/accelerator/octree/point_in_next_cell.h"

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    Vec3d o = origin, d = direction, low = cube.low;
    for (int i = 0; i < 3; ++i)
        if (direction[i] < 0) {
            o[i] = -origin[i];
            d[i] = -direction[i];
            low[i] = -(cube.low[i] + cube.side);
        }
    int axis = -1;
    double t = 0;
    for (int i = 0; i < 3; ++i)
        if (d[i] > 0 && (axis < 0 || (low[i] + cube.side - o[i]) / d[i] < t)) {
            t = (low[i] + cube.side - o[i]) / d[i];
            axis = i;
        }
    Vec3d p = o + t * d;
    p[axis] = low[axis] + cube.side + smallest / 2;
    for (int i = 0; i < 3; ++i)
        if (direction[i] < 0) p[i] = -p[i];
    return p;
}
