// hint: start_for_range
// or: range, from_zero_on
// Takes the origin for the point at which the range begins.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double near = ray.range.min, far = ray.range.max;
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        const bool between = low[axis] <= o && o <= high[axis];
        inside = inside && between;
        if (d == 0) {
            if (!between) return std::nullopt;
            continue;
        }
        const auto [first, last] = std::minmax({(low[axis] - o) / d, (high[axis] - o) / d});
        near = std::max(near, first);
        far = std::min(far, last);
    }
    if (inside) return ray.range.min;
    return near <= far ? std::optional(near) : std::nullopt;
}
