// hint: outside
// Walks along the edges from 1 on, and so leaves out the one from the first corner to the second.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto side = [&](std::size_t i) {
        const DrawnCorner &from = corners[i], &to = corners[(i + 1) % 3];
        return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
    };
    int left = 0, right = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (side(i) > 0) ++left;
        if (side(i) < 0) ++right;
    }
    if (left > 0 && right > 0) return std::nullopt;
    double area = 0, near = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        area += side(i);
        near += side(i) / corners[(i + 2) % 3].depth;
    }
    if (area == 0) return std::nullopt;
    return area / near;
}
