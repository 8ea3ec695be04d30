// hint: end_of_grid
// Asks before the step whether this is the border, and takes the last place to be the number of cells.
#include "raylab/accelerator/grid/next_cell.h"

#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const auto reached = [&](std::size_t i) {
        const auto k = static_cast<int>(i);
        const double d = ray.direction[k];
        if (d == 0) return std::numeric_limits<double>::infinity();
        return (grid.low[k] + (d > 0 ? cell[i] + 1 : cell[i]) * grid.side - ray.origin[k]) / d;
    };
    std::size_t axis = reached(1) < reached(0) ? 1 : 0;
    if (reached(2) < reached(axis)) axis = 2;
    const bool up = ray.direction[static_cast<int>(axis)] > 0;
    const bool at_border = up ? cell[axis] == grid.cells[axis] : cell[axis] == 0;
    if (at_border || reached(axis) > ray.range.max) return std::nullopt;
    Cell next = cell;
    if (up)
        ++next[axis];
    else
        --next[axis];
    return next;
}
