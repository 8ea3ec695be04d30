// hint: not_a_number
// 1 / 0, and NaN goes through min and max.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double t0 = ray.range.min, t1 = ray.range.max;
    for (int i = 0; i < 3; ++i) {
        const double inv = 1 / ray.direction[i];
        const double a = (low[i] - ray.origin[i]) * inv, b = (high[i] - ray.origin[i]) * inv;
        t0 = std::max(std::min(a, b), t0);
        t1 = std::min(std::max(a, b), t1);
    }
    if (t1 < t0) return std::nullopt;
    return t0;
}
