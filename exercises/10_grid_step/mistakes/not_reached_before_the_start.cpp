// hint: not_ahead
// A plane that is reached at 0 or before is taken for one that is never reached.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const auto reached = [&](int axis) {
        const double d = ray.direction[axis];
        if (d == 0) return never;
        const int place = cell[static_cast<std::size_t>(axis)] + (d > 0 ? 1 : 0);
        const double t = (grid.low[axis] + place * grid.side - ray.origin[axis]) / d;
        return t > 0 ? t : never;
    };
    const Vec3d all{reached(0), reached(1), reached(2)};
    const double t = std::min({all.x, all.y, all.z});
    if (t == never || t > ray.range.max) return std::nullopt;
    const std::size_t axis = t == all.x ? 0 : t == all.y ? 1 : 2;
    Cell next = cell;
    next[axis] += ray.direction[static_cast<int>(axis)] > 0 ? 1 : -1;
    if (next[axis] < 0 || next[axis] >= grid.cells[axis]) return std::nullopt;
    return next;
}
