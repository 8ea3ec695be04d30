// hint: search_on
// Looks where the ray is, along the axis that it leaves by, a billionth later than it leaves this cell: still in this
// one, where it leaves at t = 0.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    double leave = std::numeric_limits<double>::infinity();
    std::size_t first = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        if (ray.direction[axis] == 0) continue;
        const double plane = grid.low[axis] + (cell[i] + (ray.direction[axis] > 0 ? 1 : 0)) * grid.side;
        const double reached = (plane - ray.origin[axis]) / ray.direction[axis];
        if (reached >= leave) continue;
        leave = reached;
        first = i;
    }
    if (leave > ray.range.max) return std::nullopt;
    const auto axis = static_cast<int>(first);
    const double place = ray.origin[axis] + leave * (1 + 1e-9) * ray.direction[axis];
    Cell next = cell;
    next[first] = static_cast<int>(std::floor((place - grid.low[axis]) / grid.side));
    if (next[first] < 0 || next[first] >= grid.cells[first]) return std::nullopt;
    return next;
}
