// hint: end_of_grid
// Cells beyond the border.
#include "raylab/accelerator/grid/next_cell.h"

#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    double best = std::numeric_limits<double>::max();
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
        const double d = ray.direction[i];
        if (d == 0) continue;
        const int plane = cell[static_cast<std::size_t>(i)] + (d > 0 ? 1 : 0);
        const double t = (grid.low[i] + plane * grid.side - ray.origin[i]) / d;
        if (t < best) {
            best = t;
            axis = i;
        }
    }

    if (best > ray.range.max) return std::nullopt;
    Cell out = cell;
    out[static_cast<std::size_t>(axis)] += ray.direction[axis] > 0 ? 1 : -1;
    return out;
}
