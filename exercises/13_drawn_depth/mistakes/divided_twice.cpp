// hint: linear
// Shares that are right for colours in space, and 1 / depth mixed by them.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <array>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto twice_area = [](const DrawnCorner& p, const DrawnCorner& q, double u, double v) {
        return (q.x - p.x) * (v - p.y) - (q.y - p.y) * (u - p.x);
    };
    std::array<double, 3> share{};
    const double all = twice_area(corners[0], corners[1], corners[2].x, corners[2].y);
    if (all == 0) return std::nullopt;
    double sum = 0, near = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        share[i] = twice_area(corners[(i + 1) % 3], corners[(i + 2) % 3], x, y) / all;
        if (share[i] < 0) return std::nullopt;
        sum += share[i] / corners[i].depth;
    }
    for (std::size_t i = 0; i < 3; ++i) near += share[i] / corners[i].depth / sum / corners[i].depth;
    return 1 / near;
}
