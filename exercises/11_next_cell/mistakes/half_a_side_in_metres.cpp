// hint: half_cell_along
// Makes the direction one long, and goes half of this cell's side farther than to the face.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <cmath>
#include <vector>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    const Vec3d way = glm::normalize(direction), centre = cube.low + Vec3d(cube.side / 2);
    std::vector<double> metres;
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0) continue;
        const double face = centre[axis] + std::copysign(cube.side / 2, way[axis]);
        metres.push_back((face - origin[axis]) / way[axis]);
    }
    double exit = metres.front();
    for (const double other : metres) exit = std::fmin(exit, other);
    return origin + way * (exit + cube.side / 2);
}
