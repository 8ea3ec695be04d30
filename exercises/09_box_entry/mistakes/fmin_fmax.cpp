// hint: not_a_number
// 0 * infinity is passed over by fmin and fmax, and the wrong one stays.
#include "raylab/geometry/box_entry.h"

#include <cmath>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double near = ray.range.min, far = ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        const double inverse = 1 / d, a = (low[axis] - o) * inverse, b = (high[axis] - o) * inverse;
        near = std::fmax(near, std::fmin(a, b));
        far = std::fmin(far, std::fmax(a, b));
    }
    if (near > far) return std::nullopt;
    return near;
}
