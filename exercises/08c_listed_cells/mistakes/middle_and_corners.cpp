// hint: centers
// Asks at the middle of each cell and at its corners, and what shows between them is lost.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const auto shows = [&](double column, double row) {
        Vec3d way;
        way[axis] = face % 2 == 0 ? 1 : -1;
        way[(axis + 1) % 3] = 2 * column / resolution - 1;
        way[(axis + 2) % 3] = 2 * row / resolution - 1;
        const double depth = dot(normal, corners[0]) / dot(normal, way);
        if (!(depth > 0)) return false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3d edge = corners[(i + 1) % corners.size()] - corners[i];
            if (dot(cross(edge, depth * way - corners[i]), normal) < 0) return false;
        }
        return true;
    };
    std::optional<CellRectangle> all;
    for (int row = 0; row < resolution; ++row)
        for (int column = 0; column < resolution; ++column) {
            bool is_listed = shows(column + 0.5, row + 0.5);
            for (const int right : {0, 1})
                for (const int up : {0, 1}) is_listed = is_listed || shows(column + right, row + up);
            if (!is_listed) continue;
            const auto [c, d, r, s] = all.value_or(CellRectangle{column, column, row, row});
            all = CellRectangle{std::min(c, column), std::max(d, column), std::min(r, row), std::max(s, row)};
        }
    return all;
}
