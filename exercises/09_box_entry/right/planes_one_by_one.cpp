// Six planes, one after the other, with early ends.
#include "raylab/geometry/box_entry.h"

#include <algorithm>
#include <utility>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double t0 = ray.range.min, t1 = ray.range.max;
    for (int i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0) {
            if (ray.origin[i] < low[i] || high[i] < ray.origin[i]) return std::nullopt;
            continue;
        }
        double a = (low[i] - ray.origin[i]) / ray.direction[i], b = (high[i] - ray.origin[i]) / ray.direction[i];
        if (a > b) std::swap(a, b);

        if (a > t0) t0 = a;
        if (b < t1) t1 = b;
        if (t0 > t1) return std::nullopt;
    }
    return t0;
}
