// An interval for each axis, then their common part.
#include "raylab/geometry/box_entry.h"

#include <algorithm>
#include <array>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    std::array<double, 4> begins{ray.range.min, ray.range.min, ray.range.min, ray.range.min};
    std::array<double, 4> ends{ray.range.max, ray.range.max, ray.range.max, ray.range.max};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<int>(i);
        const double a = low[k] - ray.origin[k], b = high[k] - ray.origin[k], d = ray.direction[k];
        if (d == 0 && (a > 0 || b < 0)) return std::nullopt;
        if (d == 0) continue;
        begins[i] = std::min(a / d, b / d);
        ends[i] = std::max(a / d, b / d);
    }
    const double begin = *std::max_element(begins.begin(), begins.end());
    const double end = *std::min_element(ends.begin(), ends.end());
    if (begin <= end) return begin;
    return std::nullopt;
}
