// hint: outside
// 1 / depth as a linear function of the picture, which goes on beyond the triangle.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto& [p, q, r] = corners;
    const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (area == 0) return std::nullopt;
    const double rise_q = 1 / q.depth - 1 / p.depth, rise_r = 1 / r.depth - 1 / p.depth;
    const double along_x = (rise_q * (r.y - p.y) - rise_r * (q.y - p.y)) / area;
    const double along_y = (rise_r * (q.x - p.x) - rise_q * (r.x - p.x)) / area;
    return 1 / (1 / p.depth + along_x * (x - p.x) + along_y * (y - p.y));
}
