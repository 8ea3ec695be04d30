// hint: outside
// Two of the shares are asked to be from 0 to 1; the first corner's, which is the rest, may be less than 0.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto twice_area = [](const DrawnCorner& a, const DrawnCorner& b, double u, double v) {
        return (b.x - a.x) * (v - a.y) - (b.y - a.y) * (u - a.x);
    };
    const double all = twice_area(corners[0], corners[1], corners[2].x, corners[2].y);
    if (all == 0) return std::nullopt;
    double rest = 1, near = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        const double share = twice_area(corners[(i + 1) % 3], corners[(i + 2) % 3], x, y) / all;
        if (!(share >= 0 && share <= 1)) return std::nullopt;
        rest -= share;
        near += share / corners[i].depth;
    }
    return 1 / (near + rest / corners[0].depth);
}
