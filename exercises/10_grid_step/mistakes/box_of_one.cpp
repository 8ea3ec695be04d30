// hint: where_planes
// Leaves a box that reaches from low + (i, j, k) one further along each axis.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const Vec3d low = grid.low + Vec3d(cell[0], cell[1], cell[2]), high = low + Vec3d(1);
    Vec3d leave(std::numeric_limits<double>::infinity());
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d != 0) leave[axis] = std::max((low[axis] - o) / d, (high[axis] - o) / d);
    }
    const double t = std::min({leave.x, leave.y, leave.z});
    if (t > ray.range.max) return std::nullopt;
    const std::size_t axis = t == leave.x ? 0 : t == leave.y ? 1 : 2;
    Cell next = cell;
    next[axis] += ray.direction[static_cast<int>(axis)] < 0 ? -1 : 1;
    if (next[axis] == -1 || next[axis] == grid.cells[axis]) return std::nullopt;
    return next;
}
