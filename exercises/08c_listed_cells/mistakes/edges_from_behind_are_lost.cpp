// hint: lost_behind
// or: cut_edges
// Gives up at the first edge that comes from behind the light.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const int column_axis = (face / 2 + 1) % 3, row_axis = (face / 2 + 2) % 3;
    const auto depth = [&](const Vec3d& p) { return face % 2 == 0 ? p[face / 2] : -p[face / 2]; };
    CellRectangle cells{resolution, -1, resolution, -1};
    const auto take = [&](const Vec3d& p) {
        const double u = (p[column_axis] / depth(p) + 1) * 0.5 * resolution;
        const double v = (p[row_axis] / depth(p) + 1) * 0.5 * resolution;
        const auto limited = [&](double x) { return static_cast<int>(std::clamp(x, 0.0, resolution - 1.0)); };
        cells.first_column = std::min(cells.first_column, limited(std::ceil(u - 1)));
        cells.last_column = std::max(cells.last_column, limited(std::floor(u)));
        cells.first_row = std::min(cells.first_row, limited(std::ceil(v - 1)));
        cells.last_row = std::max(cells.last_row, limited(std::floor(v)));
    };
    bool all_left = true, all_right = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d p = corners[i], q = corners[(i + 1) % corners.size()];
        if (depth(p) * depth(q) <= 0) return std::nullopt;
        double from = 0, to = 1;
        for (const int axis : {column_axis, row_axis})
            for (const double side : {-1.0, 1.0}) {
                const double a = depth(p) - side * p[axis], b = depth(q) - side * q[axis];
                if (a < 0 && b < 0) from = infinity;
                if (a < 0 && b >= 0) from = std::max(from, a / (a - b));
                if (a >= 0 && b < 0) to = std::min(to, a / (a - b));
            }
        if (from > to) continue;
        take(p + from * (q - p));
        take(p + to * (q - p));
    }
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (const double u : {-1.0, 1.0})
        for (const double v : {-1.0, 1.0}) {
            Vec3d way{0};
            way[face / 2] = face % 2 == 0 ? 1 : -1;
            way[column_axis] = u;
            way[row_axis] = v;
            all_left = all_right = true;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const double side = dot(cross(corners[i], corners[(i + 1) % corners.size()]), way);
                all_left = all_left && side >= 0;
                all_right = all_right && side <= 0;
            }
            if ((all_left || all_right) && dot(normal, corners[0]) * dot(normal, way) > 0) take(way);
        }
    if (cells.last_column < 0) return std::nullopt;
    return cells;
}
