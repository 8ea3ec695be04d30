// hint: came_in_by
// Of all six planes the one with the smallest positive t.
#include "raylab/accelerator/grid/next_cell.h"

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::optional<double> first;
    Cell next = cell;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
            const double plane = grid.low[axis] + (cell[axis] + side) * grid.side;
            const double t = (plane - ray.origin[axis]) / ray.direction[axis];
            if (!(t > 0) || (first && t >= *first)) continue;
            first = t;
            next = cell;
            next[axis] += side == 0 ? -1 : 1;
        }
    if (!first || *first > ray.range.max) return std::nullopt;
    for (int axis = 0; axis < 3; ++axis)
        if (next[axis] < 0 || next[axis] >= grid.cells[axis]) return std::nullopt;
    return next;
}
