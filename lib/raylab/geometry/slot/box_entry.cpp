#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    Interval<double> inside = ray.range;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis], direction = ray.direction[axis];
        if (direction == 0) {  // between the planes all along, or never: 0 / 0 could not tell
            if (origin < low[axis] || origin > high[axis]) return std::nullopt;
            continue;
        }
        const double at_low = (low[axis] - origin) / direction, at_high = (high[axis] - origin) / direction;
        inside.min = std::max(inside.min, std::min(at_low, at_high));
        inside.max = std::min(inside.max, std::max(at_low, at_high));
    }
    if (inside.min > inside.max) return std::nullopt;
    return inside.min;
}
