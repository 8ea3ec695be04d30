// The ray's range clipped by six half-spaces, one after the other (Liang and Barsky 1984).
#include "raylab/geometry/box_entry.h"

#include <algorithm>

namespace {

// What of the range is where height + t * speed >= 0.
bool clip(double height, double speed, double& from, double& to) {
    if (speed > 0) from = std::max(from, -height / speed);
    if (speed < 0) to = std::min(to, -height / speed);
    return speed != 0 || height >= 0;
}

}  // namespace

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    auto [from, to] = ray.range;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (!clip(o - low[axis], d, from, to) || !clip(high[axis] - o, -d, from, to)) return std::nullopt;
    }
    if (to < from) return std::nullopt;
    return from;
}
