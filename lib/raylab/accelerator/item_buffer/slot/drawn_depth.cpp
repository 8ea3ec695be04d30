#include "raylab/accelerator/item_buffer/drawn_depth.h"

// Three edge functions say whether the place is covered, and are also the corners' weights. What is linear in the
// picture is 1 / depth.
std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto edge = [&](const DrawnCorner& a, const DrawnCorner& b) {
        return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    };
    const auto& [p, q, r] = corners;
    const double a = edge(q, r), b = edge(r, p), c = edge(p, q);
    const bool covers = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    if (!covers || a + b + c == 0) return std::nullopt;
    return (a + b + c) / (a / p.depth + b / q.depth + c / r.depth);
}
