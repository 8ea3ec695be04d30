// The exit of the cell's box by slabs: each axis's later plane, the earliest of these; then the axis that has it.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    Vec3d leave(std::numeric_limits<double>::infinity());
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0) continue;
        const double low = grid.low[axis] + cell[static_cast<std::size_t>(axis)] * grid.side, high = low + grid.side;
        leave[axis] =
            std::max((low - ray.origin[axis]) / ray.direction[axis], (high - ray.origin[axis]) / ray.direction[axis]);
    }
    const double t = std::min({leave.x, leave.y, leave.z});
    if (!(t <= ray.range.max) || t == std::numeric_limits<double>::infinity()) return std::nullopt;
    const std::size_t axis = t == leave.x ? 0 : t == leave.y ? 1 : 2;
    Cell next = cell;
    next[axis] = ray.direction[static_cast<int>(axis)] < 0 ? cell[axis] - 1 : cell[axis] + 1;
    if (next[axis] == -1 || next[axis] == grid.cells[axis]) return std::nullopt;
    return next;
}
