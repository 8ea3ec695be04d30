// hint: thrown_over
// or: behind_too, cut_first, partly_seen
// Each corner's own cell, moved onto the face, behind the light or not.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    CellRectangle cells{resolution - 1, 0, resolution - 1, 0};
    for (const Vec3d& p : corners) {
        const double w = face % 2 == 0 ? p[axis] : -p[axis];
        const double column = std::clamp((p[(axis + 1) % 3] / w + 1) / 2 * resolution, 0.0, double(resolution));
        const double row = std::clamp((p[(axis + 2) % 3] / w + 1) / 2 * resolution, 0.0, double(resolution));
        cells.first_column = std::min(cells.first_column, std::max(static_cast<int>(std::ceil(column)) - 1, 0));
        cells.last_column = std::max(cells.last_column, std::min(static_cast<int>(column), resolution - 1));
        cells.first_row = std::min(cells.first_row, std::max(static_cast<int>(std::ceil(row)) - 1, 0));
        cells.last_row = std::max(cells.last_row, std::min(static_cast<int>(row), resolution - 1));
    }
    return cells;
}
