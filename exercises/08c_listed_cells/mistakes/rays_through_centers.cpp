// hint: centers
// Asks the ray through each cell's centre whether it hits the polygon.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    CellRectangle cells{resolution, -1, resolution, -1};
    for (int row = 0; row < resolution; ++row)
        for (int column = 0; column < resolution; ++column) {
            Vec3d way{0};
            way[axis] = face % 2 == 0 ? 1 : -1;
            way[(axis + 1) % 3] = (column + 0.5) / resolution * 2 - 1;
            way[(axis + 2) % 3] = (row + 0.5) / resolution * 2 - 1;
            const double t = dot(normal, corners[0]) / dot(normal, way);
            if (!(t > 0)) continue;
            bool is_hit = true;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Vec3d edge = corners[(i + 1) % corners.size()] - corners[i];
                if (dot(cross(edge, t * way - corners[i]), normal) < 0) is_hit = false;
            }
            if (!is_hit) continue;
            cells = {std::min(cells.first_column, column), std::max(cells.last_column, column),
                     std::min(cells.first_row, row), std::max(cells.last_row, row)};
        }
    if (cells.last_column < 0) return std::nullopt;
    return cells;
}
