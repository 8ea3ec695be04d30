// hint: fixed_step
// Turns the ray so that it runs upward along all axes, and goes 0.5 beyond the face: half of a cell that is 1 wide.
#include "raylab/accelerator/octree/point_in_next_cell.h"

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    Vec3d o = origin, d = direction, high = cube.low + Vec3d(cube.side);
    for (int i = 0; i < 3; ++i)
        if (direction[i] < 0) {
            o[i] = -origin[i];
            d[i] = -direction[i];
            high[i] = -cube.low[i];
        }
    int axis = -1;
    for (int i = 0; i < 3; ++i)
        if (d[i] > 0 && (axis < 0 || (high[i] - o[i]) / d[i] < (high[axis] - o[axis]) / d[axis])) axis = i;
    Vec3d point = o + (high[axis] - o[axis]) / d[axis] * d;
    point[axis] = high[axis] + 0.5;
    for (int i = 0; i < 3; ++i)
        if (direction[i] < 0) point[i] = -point[i];
    return point;
}
