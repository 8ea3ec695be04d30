// Cuts the polygon at the pyramid of each cell.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2, n = resolution;
    std::vector<Vec3d> given;
    for (const Vec3d& p : corners)
        given.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], face % 2 == 0 ? p[axis] : -p[axis]});
    const auto is_seen = [&](int column, int row) {
        std::vector<Vec3d> left = given;
        for (const Vec3d& inward :
             {Vec3d{double(n), 0, double(n - 2 * column)}, Vec3d{double(-n), 0, double(2 * column + 2 - n)},
              Vec3d{0, double(n), double(n - 2 * row)}, Vec3d{0, double(-n), double(2 * row + 2 - n)},
              Vec3d{0, 0, 1}}) {
            std::vector<Vec3d> kept;
            for (std::size_t i = 0; i < left.size(); ++i) {
                const Vec3d &a = left[i], &b = left[i + 1 < left.size() ? i + 1 : 0];
                const double from = dot(inward, a), to = dot(inward, b);
                if (from >= 0) kept.push_back(a);
                if (from * to < 0) kept.push_back((a * to - b * from) / (to - from));
            }
            left = kept;
        }
        return !left.empty();
    };
    std::optional<CellRectangle> cells;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            if (!is_seen(column, row)) continue;
            if (!cells) cells = CellRectangle{column, column, row, row};
            cells->first_column = std::min(cells->first_column, column);
            cells->last_column = std::max(cells->last_column, column);
            cells->first_row = std::min(cells->first_row, row);
            cells->last_row = std::max(cells->last_row, row);
        }
    return cells;
}
