// hint: longest_component
// Goes where the direction points most.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    int largest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(ray.direction[axis]) > std::abs(ray.direction[largest])) largest = axis;
    const auto i = static_cast<std::size_t>(largest);
    const bool up = ray.direction[largest] > 0;
    const double t =
        (grid.low[largest] + (cell[i] + (up ? 1 : 0)) * grid.side - ray.origin[largest]) / ray.direction[largest];
    if (t > ray.range.max) return std::nullopt;
    Cell next = cell;
    next[i] += up ? 1 : -1;
    if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    return next;
}
