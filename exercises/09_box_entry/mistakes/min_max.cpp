// hint: not_a_number
// 0 * infinity goes through std::min and std::max as it likes.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double near = ray.range.min, far = ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        const double inverse = 1 / d, a = (low[axis] - o) * inverse, b = (high[axis] - o) * inverse;
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    if (near > far) return std::nullopt;
    return near;
}
