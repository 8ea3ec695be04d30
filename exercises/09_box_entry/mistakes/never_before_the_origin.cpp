// hint: from_zero_on
// The ray is taken to begin at its origin: of the entries, range.min and 0 the latest one counts.
#include "raylab/geometry/box_entry.h"

#include <algorithm>
#include <array>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    std::array<double, 5> begins{0, ray.range.min, 0, 0, 0};
    std::array<double, 4> ends{ray.range.max, ray.range.max, ray.range.max, ray.range.max};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        const double d = ray.direction[axis], to_low = low[axis] - ray.origin[axis],
                     to_high = high[axis] - ray.origin[axis];
        if (d == 0 && (to_low > 0 || to_high < 0)) return std::nullopt;
        if (d == 0) continue;
        begins[2 + i] = std::min(to_low / d, to_high / d);
        ends[1 + i] = std::max(to_low / d, to_high / d);
    }
    const double begin = *std::ranges::max_element(begins), end = *std::ranges::min_element(ends);
    if (begin > end) return std::nullopt;
    return begin;
}
