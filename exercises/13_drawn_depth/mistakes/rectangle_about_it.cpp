// hint: outside
// Covered is the rectangle about the triangle.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <algorithm>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto& [p, q, r] = corners;
    const double a = (r.x - q.x) * (y - q.y) - (r.y - q.y) * (x - q.x);
    const double b = (p.x - r.x) * (y - r.y) - (p.y - r.y) * (x - r.x);
    const double c = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    if (a + b + c == 0) return std::nullopt;
    if (x < std::min({p.x, q.x, r.x}) || x > std::max({p.x, q.x, r.x})) return std::nullopt;
    if (y < std::min({p.y, q.y, r.y}) || y > std::max({p.y, q.y, r.y})) return std::nullopt;
    return (a + b + c) / (a / p.depth + b / q.depth + c / r.depth);
}
