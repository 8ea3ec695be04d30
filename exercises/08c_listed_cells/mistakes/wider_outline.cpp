// hint: too_wide
// The outline is made wider by a cell before it is counted.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    std::vector<Vec3d> outline(corners.begin(), corners.end());
    for (const int across : {(axis + 1) % 3, (axis + 2) % 3})
        for (const double way : {1.0, -1.0}) {
            Vec3d side{0};
            side[axis] = face % 2 == 0 ? 1 : -1;
            side[across] = way;
            std::vector<Vec3d> inside;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const Vec3d &p = outline[i], &q = outline[(i + 1) % outline.size()];
                const double a = dot(side, p), b = dot(side, q);
                if (a >= 0) inside.push_back(p);
                if (a * b < 0) inside.push_back((a * q - b * p) / (a - b));
            }
            outline = inside;
        }
    if (outline.empty()) return std::nullopt;
    std::array<int, 4> cells{};
    for (int i = 0; i < 2; ++i) {
        const int across = (axis + 1 + i) % 3;
        double least = 1, most = -1;
        for (const Vec3d& p : outline) {
            least = std::min(least, p[across] / std::abs(p[axis]));
            most = std::max(most, p[across] / std::abs(p[axis]));
        }
        const double cell = 2.0 / resolution;
        const auto number = [&](double x) {
            return std::clamp(static_cast<int>(std::floor((x + 1) / cell)), 0, resolution - 1);
        };
        cells[static_cast<std::size_t>(2 * i)] = number(least - cell);
        cells[static_cast<std::size_t>(2 * i + 1)] = number(most + cell);
    }
    return CellRectangle{cells[0], cells[1], cells[2], cells[3]};
}
