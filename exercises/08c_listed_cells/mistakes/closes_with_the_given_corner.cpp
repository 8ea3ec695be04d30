// hint: last_edge
// or: cut_edges, partly_seen
// Each cut begins with the last corner that was given, though others may be left.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1 : -1;
    std::vector<Vec3d> seen;
    for (const Vec3d& p : corners) seen.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], sign * p[axis]});
    const Vec3d last = seen.back();
    for (int side = 3; side >= 0; --side) {
        const auto above = [&](const Vec3d& p) { return side % 2 == 0 ? p.z - p[side / 2] : p.z + p[side / 2]; };
        std::vector<Vec3d> kept;
        Vec3d before = last;
        for (const Vec3d& corner : seen) {
            const double from = above(before), to = above(corner);
            if (from * to < 0) kept.push_back(before + from / (from - to) * (corner - before));
            if (to >= 0) kept.push_back(corner);
            before = corner;
        }
        seen = kept;
    }
    if (seen.empty()) return std::nullopt;
    double left = 1, right = -1, low = 1, high = -1;
    for (const Vec3d& p : seen) {
        left = std::min(left, p.x / p.z);
        right = std::max(right, p.x / p.z);
        low = std::min(low, p.y / p.z);
        high = std::max(high, p.y / p.z);
    }
    const auto place = [&](double x) { return (x + 1) / 2 * resolution; };
    const auto cell = [&](double x) { return std::clamp(static_cast<int>(x), 0, resolution - 1); };
    return CellRectangle{cell(std::ceil(place(left)) - 1), cell(std::floor(place(right))),
                         cell(std::ceil(place(low)) - 1), cell(std::floor(place(high)))};
}
