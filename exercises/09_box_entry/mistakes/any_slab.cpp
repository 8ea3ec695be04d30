// hint: all_three
// The earliest entry and the latest exit: between the planes of one axis is not enough.
#include "raylab/geometry/box_entry.h"

#include <algorithm>
#include <limits>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double near = std::numeric_limits<double>::infinity(), far = -near;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0) {
            if (o < low[axis] || o > high[axis]) return std::nullopt;
            continue;
        }
        const double a = (low[axis] - o) / d, b = (high[axis] - o) / d;
        near = std::min(near, std::min(a, b));
        far = std::max(far, std::max(a, b));
    }
    near = std::max(near, ray.range.min);
    far = std::min(far, ray.range.max);
    if (near > far) return std::nullopt;
    return near;
}
