// hint: small_is_not_zero
// A fixed number tells which axes are parallel.
#include "raylab/geometry/box_entry.h"

#include <algorithm>
#include <cmath>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double t0 = ray.range.min, t1 = ray.range.max;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(ray.direction[i]) < 1e-8) {
            if (ray.origin[i] < low[i] || high[i] < ray.origin[i]) return std::nullopt;
            continue;
        }
        const double inv = 1 / ray.direction[i];
        const double a = (low[i] - ray.origin[i]) * inv, b = (high[i] - ray.origin[i]) * inv;
        t0 = std::max(t0, std::min(a, b));
        t1 = std::min(t1, std::max(a, b));
    }
    return t0 <= t1 ? std::optional(t0) : std::nullopt;
}
