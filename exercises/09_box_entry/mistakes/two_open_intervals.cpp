// hint: closed_range
// First where the whole line is in the box. Then it asks whether that overlaps the range, as if both were open.
#include "raylab/geometry/box_entry.h"

#include <algorithm>
#include <limits>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double leaves = std::numeric_limits<double>::infinity(), enters = -leaves;
    for (int i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0) {
            if (!(low[i] <= ray.origin[i] && ray.origin[i] <= high[i])) return std::nullopt;
        } else {
            const auto [first, last] = std::minmax(
                {(low[i] - ray.origin[i]) / ray.direction[i], (high[i] - ray.origin[i]) / ray.direction[i]});
            enters = std::max(enters, first);
            leaves = std::min(leaves, last);
        }
    }
    const bool is_in_box = enters <= leaves, overlaps = enters < ray.range.max && leaves > ray.range.min;
    if (!is_in_box || !overlaps) return std::nullopt;
    return std::max(enters, ray.range.min);
}
