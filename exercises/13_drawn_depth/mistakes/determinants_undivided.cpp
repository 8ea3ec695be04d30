// hint: normalised
// Cramer's rule without its division: determinants are taken for shares.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const DrawnCorner &p = corners[0], &q = corners[1], &r = corners[2];
    double u = (x - p.x) * (r.y - p.y) - (y - p.y) * (r.x - p.x);
    double v = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (area == 0) return std::nullopt;
    if (area < 0) {
        u = -u;
        v = -v;
        area = -area;
    }
    const double rest = area - u - v;
    if (u < 0 || v < 0 || rest < 0) return std::nullopt;
    return 1 / (rest / p.depth + u / q.depth + v / r.depth);
}
