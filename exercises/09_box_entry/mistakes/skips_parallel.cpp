// hint: parallel
// Axes along which the ray does not move are not asked.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double t0 = ray.range.min, t1 = ray.range.max;
    for (int i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0) continue;
        const double inv = 1 / ray.direction[i];
        const double a = (low[i] - ray.origin[i]) * inv, b = (high[i] - ray.origin[i]) * inv;
        t0 = std::max(t0, std::min(a, b));
        t1 = std::min(t1, std::max(a, b));
    }
    return t0 <= t1 ? std::optional(t0) : std::nullopt;
}
