// hint: cut_first
// or: partly_seen
// Follows edges as far as they are in front of the light, however far beyond the face that is.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2, across = (axis + 1) % 3, up = (axis + 2) % 3;
    const auto depth = [&](const Vec3d& p) { return face % 2 == 0 ? p[axis] : -p[axis]; };
    constexpr double nearest = 1e-9;
    double column[] = {1e12, -1e12}, row[] = {1e12, -1e12};  // the least and the greatest place
    const auto take = [&](const Vec3d& p) {
        const double u = p[across] / depth(p), v = p[up] / depth(p);
        column[0] = std::min(column[0], u);
        column[1] = std::max(column[1], u);
        row[0] = std::min(row[0], v);
        row[1] = std::max(row[1], v);
    };
    Vec3d before = corners.back();
    for (const Vec3d& corner : corners) {
        const double from = depth(before) - nearest, to = depth(corner) - nearest;
        if (from * to < 0) take(before + from / (from - to) * (corner - before));
        if (to >= 0) take(corner);
        before = corner;
    }
    if (column[0] > 1 || column[1] < -1 || row[0] > 1 || row[1] < -1) return std::nullopt;

    const auto place = [&](double x) { return (std::clamp(x, -1.0, 1.0) + 1) / 2 * resolution; };
    const auto first = [&](double x) { return std::max(static_cast<int>(std::ceil(place(x))) - 1, 0); };
    const auto last = [&](double x) { return std::min(static_cast<int>(place(x)), resolution - 1); };
    return CellRectangle{first(column[0]), last(column[1]), first(row[0]), last(row[1])};
}
