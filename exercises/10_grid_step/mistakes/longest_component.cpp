// hint: longest_component
// Goes where the direction points most.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    int most = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(ray.direction[axis]) > std::abs(ray.direction[most])) most = axis;
    const auto i = static_cast<std::size_t>(most);
    const bool up = ray.direction[most] > 0;
    const double t = (grid.low[most] + (cell[i] + (up ? 1 : 0)) * grid.side - ray.origin[most]) / ray.direction[most];
    if (t > ray.range.max) return std::nullopt;
    Cell next = cell;
    next[i] += up ? 1 : -1;
    if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    return next;
}
