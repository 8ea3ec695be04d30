// hint: stale_range
// Inverts the direction once a ray, and keeps the range it had then with it.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

namespace {

struct Prepared {
    raylab::RayOf<double> ray{};
    raylab::Vec3d inverse{};
};

}  // namespace

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    static Prepared last;
    if (ray.origin != last.ray.origin || ray.direction != last.ray.direction || ray.range.min != last.ray.range.min)
        last = {ray, 1.0 / ray.direction};
    double near = last.ray.range.min, far = last.ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0) {
            if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) return std::nullopt;
            continue;
        }
        const double a = (low[axis] - ray.origin[axis]) * last.inverse[axis],
                     b = (high[axis] - ray.origin[axis]) * last.inverse[axis];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far ? std::optional(near) : std::nullopt;
}
