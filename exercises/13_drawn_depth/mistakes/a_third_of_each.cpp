// hint: corner_depth
// Finds shares to see that the place is covered, and then gives each corner a third.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const double ux = corners[1].x - corners[0].x, uy = corners[1].y - corners[0].y;
    const double vx = corners[2].x - corners[0].x, vy = corners[2].y - corners[0].y;
    const double dx = x - corners[0].x, dy = y - corners[0].y;
    const double area = ux * vy - uy * vx;
    if (area == 0) return std::nullopt;
    const double u = (dx * vy - dy * vx) / area, v = (ux * dy - uy * dx) / area;
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    double depth = 0;
    for (const DrawnCorner& corner : corners) depth += corner.depth / 3;
    return depth;
}
