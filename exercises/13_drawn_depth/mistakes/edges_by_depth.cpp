// hint: linear
// Mixes the depth itself along the edges, and 1 / depth only along the line between them.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <algorithm>
#include <vector>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto side = [&](std::size_t i) {
        const DrawnCorner &a = corners[i], &b = corners[(i + 1) % 3];
        return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    };
    const double s = side(0), t = side(1), r = side(2);
    if (s + t + r == 0 || (std::min({s, t, r}) < 0 && std::max({s, t, r}) > 0)) return std::nullopt;

    struct End {
        double x, depth;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < 3; ++i) {
        const DrawnCorner &a = corners[i], &b = corners[(i + 1) % 3];
        if (a.y == y) ends.push_back({a.x, a.depth});
        if ((a.y < y && y < b.y) || (b.y < y && y < a.y)) {
            const double share = (y - a.y) / (b.y - a.y);
            ends.push_back({a.x + share * (b.x - a.x), a.depth + share * (b.depth - a.depth)});
        }
    }
    const auto [left, right] = std::ranges::minmax(ends, {}, &End::x);
    if (left.x == right.x) return left.depth;
    const double share = (x - left.x) / (right.x - left.x);
    return 1 / ((1 - share) / left.depth + share / right.depth);
}
