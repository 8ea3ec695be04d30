// hint: closed
// Clips by six half-spaces, and a ray at height 0 above a plane is taken to be outside.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double from = ray.range.min, to = ray.range.max;
    const auto clip = [&](double height, double speed) {
        if (speed == 0) return height > 0;
        if (speed > 0)
            from = std::max(from, -height / speed);
        else
            to = std::min(to, -height / speed);
        return from <= to;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (!clip(o - low[axis], d)) return std::nullopt;
        if (!clip(high[axis] - o, -d)) return std::nullopt;
    }
    return from;
}
