// hint: cut_first
// or: partly_seen, four_sides
// Cuts at the sides left and right, and the rows afterwards.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1 : -1;
    std::vector<Vec3d> seen;
    for (const Vec3d& p : corners) seen.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], sign * p[axis]});
    for (int side = 0; side < 2; ++side) {
        const auto above = [&](const Vec3d& p) { return side % 2 == 0 ? p.z - p[side / 2] : p.z + p[side / 2]; };
        std::vector<Vec3d> kept;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Vec3d a = seen[i], b = seen[(i + 1) % seen.size()];
            const double from = above(a), to = above(b);
            if (from >= 0) kept.push_back(a);
            if ((from >= 0) != (to >= 0)) kept.push_back(a + from / (from - to) * (b - a));
        }
        seen = kept;
    }
    if (seen.empty()) return std::nullopt;
    double left = 1, right = -1, low = 1e12, high = -1e12;
    for (const Vec3d& p : seen) {
        left = std::min(left, p.x / p.z);
        right = std::max(right, p.x / p.z);
        low = std::min(low, p.y / p.z);
        high = std::max(high, p.y / p.z);
    }
    if (low > 1 || high < -1) return std::nullopt;
    const auto place = [&](double x) { return (x + 1) / 2 * resolution; };
    const auto cell = [&](double x) {
        return std::clamp(static_cast<int>(std::clamp(x, -1e6, 1e6)), 0, resolution - 1);
    };
    return CellRectangle{cell(std::ceil(place(left)) - 1), cell(std::floor(place(right))),
                         cell(std::ceil(place(low)) - 1), cell(std::floor(place(high)))};
}
