// hint: search_on
// Looks which cell the ray is in a billionth later than it leaves this one: still in this one, where it leaves at t =
// 0.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    double leave = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        if (ray.direction[axis] == 0) continue;
        const double plane = grid.low[axis] + (cell[i] + (ray.direction[axis] > 0 ? 1 : 0)) * grid.side;
        leave = std::min(leave, (plane - ray.origin[axis]) / ray.direction[axis]);
    }
    if (leave > ray.range.max) return std::nullopt;
    const double t = leave * (1 + 1e-9);
    Cell next{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        next[i] =
            static_cast<int>(std::floor((ray.origin[axis] + t * ray.direction[axis] - grid.low[axis]) / grid.side));
        if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    }
    return next;
}
