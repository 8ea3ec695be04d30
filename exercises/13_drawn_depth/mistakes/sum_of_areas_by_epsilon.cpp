// hint: small
// Inside where three areas add up to the whole, to a billionth of a unit.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <cmath>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto twice_the_area = [](double px, double py, double qx, double qy) { return std::abs(px * qy - py * qx); };
    std::array<double, 3> weights{};
    double sum = 0, inverse_depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const DrawnCorner &next = corners[(i + 1) % 3], &last = corners[(i + 2) % 3];
        weights[i] = twice_the_area(next.x - x, next.y - y, last.x - x, last.y - y);
        sum += weights[i];
    }
    const auto& [a, b, c] = corners;
    const double whole = twice_the_area(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
    if (whole == 0 || std::abs(sum - whole) > 1e-9) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) inverse_depth += weights[i] / whole / corners[i].depth;
    return 1 / inverse_depth;
}
