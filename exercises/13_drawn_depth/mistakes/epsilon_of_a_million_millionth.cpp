// hint: small
// No area unless it is over a millionth of a millionth.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <cmath>

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const DrawnCorner& p = corners[0];
    const double ux = corners[1].x - p.x, uy = corners[1].y - p.y, vx = corners[2].x - p.x, vy = corners[2].y - p.y;
    const double area = ux * vy - uy * vx;
    if (std::abs(area) < 1e-12) return std::nullopt;
    const double s = ((x - p.x) * vy - (y - p.y) * vx) / area, t = (ux * (y - p.y) - uy * (x - p.x)) / area;
    if (s < 0 || t < 0 || s + t > 1) return std::nullopt;
    return 1 / ((1 - s - t) / p.depth + s / corners[1].depth + t / corners[2].depth);
}
