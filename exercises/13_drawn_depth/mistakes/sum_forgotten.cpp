// hint: normalised
// Does not divide by the sum of the areas.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <cmath>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto& [p, q, r] = corners;
    const double a = (r.x - q.x) * (y - q.y) - (r.y - q.y) * (x - q.x);
    const double b = (p.x - r.x) * (y - r.y) - (p.y - r.y) * (x - r.x);
    const double c = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    if (a + b + c == 0) return std::nullopt;
    if (!(a >= 0 && b >= 0 && c >= 0) && !(a <= 0 && b <= 0 && c <= 0)) return std::nullopt;
    return 1 / (std::abs(a) / p.depth + std::abs(b) / q.depth + std::abs(c) / r.depth);
}
