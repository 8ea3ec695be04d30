// The shares in space: an area over a depth, made to add up to 1.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <cmath>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    double share[3], sum = 0;
    int positive = 0, negative = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const DrawnCorner &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
        const double twice = (b.x - x) * (c.y - y) - (b.y - y) * (c.x - x);
        if (twice > 0) ++positive;
        if (twice < 0) ++negative;
        share[i] = std::abs(twice) / corners[i].depth;
        sum += share[i];
    }
    const auto& [p, q, r] = corners;
    const bool is_flat = (q.x - p.x) * (r.y - p.y) == (q.y - p.y) * (r.x - p.x);
    if (is_flat || (positive && negative)) return std::nullopt;
    double depth = 0;
    for (std::size_t i = 0; i < 3; ++i) depth += share[i] / sum * corners[i].depth;
    return depth;
}
