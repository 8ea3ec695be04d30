// hint: linear
// Fills upright lines: along the two edges that a line crosses 1 / depth is mixed, and between them the depth itself.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <algorithm>
#include <vector>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto side = [&](std::size_t i) {
        const DrawnCorner &a = corners[i], &b = corners[(i + 1) % 3];
        return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    };
    const auto [least, most] = std::minmax({side(0), side(1), side(2)});
    if ((least < 0 && most > 0) || (least == 0 && most == 0)) return std::nullopt;
    if (side(0) + side(1) + side(2) == 0) return std::nullopt;

    struct End {
        double y, depth;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < 3; ++i) {
        const DrawnCorner &a = corners[i], &b = corners[(i + 1) % 3];
        if (a.x == x) ends.push_back({a.y, a.depth});
        if ((a.x < x && x < b.x) || (b.x < x && x < a.x)) {
            const double share = (x - a.x) / (b.x - a.x);
            ends.push_back({a.y + share * (b.y - a.y), 1 / ((1 - share) / a.depth + share / b.depth)});
        }
    }
    const auto [low, high] = std::ranges::minmax(ends, {}, &End::y);
    if (low.y == high.y) return low.depth;
    return low.depth + (y - low.y) / (high.y - low.y) * (high.depth - low.depth);
}
