// hint: corner_depth
// Sorts the corners by depth, and gives the first one's wherever the triangle covers the place.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <algorithm>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    auto sorted = corners;
    std::ranges::sort(sorted, {}, &DrawnCorner::depth);
    const auto& [p, q, r] = sorted;
    const auto is_left_of = [&](const DrawnCorner& from, const DrawnCorner& to) {
        return (to.x - from.x) * (y - from.y) > (to.y - from.y) * (x - from.x);
    };
    const auto is_right_of = [&](const DrawnCorner& from, const DrawnCorner& to) { return is_left_of(to, from); };
    const bool left = is_left_of(p, q) || is_left_of(q, r) || is_left_of(r, p);
    const bool right = is_right_of(p, q) || is_right_of(q, r) || is_right_of(r, p);
    if (left == right) return std::nullopt;
    return p.depth;
}
