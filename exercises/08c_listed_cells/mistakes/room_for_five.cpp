// hint: more_corners
// Has room for five corners, though cutting makes more of them.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

raylab::Vec3d seen(const raylab::Vec3d& p, int face) {
    const int axis = face / 2;
    return {p[(axis + 1) % 3], p[(axis + 2) % 3], face % 2 == 0 ? p[axis] : -p[axis]};
}

// What is left of a polygon where w >= x p.x + y p.y, five corners of it.
std::vector<raylab::Vec3d> cut(const std::vector<raylab::Vec3d>& polygon, double x, double y) {
    const auto above = [&](const raylab::Vec3d& p) { return p.z - x * p.x - y * p.y; };
    std::vector<raylab::Vec3d> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = above(from), b = above(to);
        if (a >= 0) left.push_back(from);
        if (std::min(a, b) < 0 && std::max(a, b) > 0) left.push_back(from + a / (a - b) * (to - from));
    }
    left.resize(std::min<std::size_t>(left.size(), 5));
    return left;
}

}  // namespace

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    std::vector<Vec3d> polygon;
    for (const Vec3d& corner : corners) polygon.push_back(seen(corner, face));
    for (const double side : {-1.0, 1.0}) polygon = cut(cut(polygon, side, 0), 0, side);
    if (polygon.empty()) return std::nullopt;
    CellRectangle cells{resolution - 1, 0, resolution - 1, 0};
    const auto take = [&](double place, int& first, int& last) {
        const double number = (place + 1) / 2 * resolution;
        first = std::min(first, std::max(0, static_cast<int>(std::ceil(number)) - 1));
        last = std::max(last, std::min(static_cast<int>(number), resolution - 1));
    };
    for (const Vec3d& p : polygon) {
        take(p.x / p.z, cells.first_column, cells.last_column);
        take(p.y / p.z, cells.first_row, cells.last_row);
    }
    return cells;
}
