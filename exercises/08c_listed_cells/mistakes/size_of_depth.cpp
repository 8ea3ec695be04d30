// hint: thrown_over
// or: behind_too, partly_seen
// Divides by the size of w, in front of the light and behind it.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    std::vector<Vec3d> seen;
    for (const Vec3d& p : corners) seen.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], std::abs(p[axis])});
    if (seen.empty()) return std::nullopt;
    double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
    for (const Vec3d& p : seen) {
        left = std::min(left, p.x / p.z);
        right = std::max(right, p.x / p.z);
        low = std::min(low, p.y / p.z);
        high = std::max(high, p.y / p.z);
    }
    if (left > 1 || right < -1 || low > 1 || high < -1) return std::nullopt;
    const auto place = [&](double x) { return (x + 1) / 2 * resolution; };
    const auto cell = [&](double x) {
        return std::clamp(static_cast<int>(std::clamp(x, -1e6, 1e6)), 0, resolution - 1);
    };
    return CellRectangle{cell(std::ceil(place(left)) - 1), cell(std::floor(place(right))),
                         cell(std::ceil(place(low)) - 1), cell(std::floor(place(high)))};
}
