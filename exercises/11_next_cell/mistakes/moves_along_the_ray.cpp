// hint: along_the_ray
// Half a smallest cell further along the ray, on all axes.
#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <limits>

raylab::Vec3d raylab::point_in_next_cell(const OctreeCube& cube, double smallest, const Vec3d& origin,
                                         const Vec3d& direction) {
    double t = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0) continue;
        const double face = direction[i] > 0 ? cube.low[i] + cube.side : cube.low[i];
        const double at = (face - origin[i]) / direction[i];
        if (at < t) t = at;
    }
    Vec3d p = origin + t * direction;
    return p + 0.5 * smallest * glm::normalize(direction);
}
