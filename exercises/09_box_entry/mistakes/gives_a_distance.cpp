// hint: distance
// Gives how far off the entry is in space.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double from = ray.range.min, to = ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0) {
            if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) return std::nullopt;
            continue;
        }
        const double one = (low[axis] - ray.origin[axis]) / ray.direction[axis];
        const double other = (high[axis] - ray.origin[axis]) / ray.direction[axis];
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
    }
    if (from > to) return std::nullopt;
    return from * glm::length(ray.direction);
}
