// hint: from_zero_on
// Nothing counts before t = 0, whatever the range says.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double near = std::max(0.0, ray.range.min), far = ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0) {
            if (o < low[axis] || o > high[axis]) return std::nullopt;
            continue;
        }
        const double a = (low[axis] - o) / d, b = (high[axis] - o) / d;
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    if (near > far) return std::nullopt;
    return near;
}
