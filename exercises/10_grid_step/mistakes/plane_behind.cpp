// hint: sign
// Takes the planes behind the ray for those ahead of it, and steps the right way.
#include "raylab/accelerator/grid/next_cell.h"

#include <array>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::array<double, 3> t{};
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        const int plane = cell[static_cast<std::size_t>(axis)] + (d < 0 ? 1 : 0);
        t[static_cast<std::size_t>(axis)] = d == 0 ? std::numeric_limits<double>::infinity()
                                                   : (grid.low[axis] + plane * grid.side - ray.origin[axis]) / d;
    }
    const std::size_t first = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
    if (t[first] > ray.range.max) return std::nullopt;
    Cell next = cell;
    next[first] += ray.direction[static_cast<int>(first)] > 0 ? 1 : -1;
    if (next[first] < 0 || next[first] >= grid.cells[first]) return std::nullopt;
    return next;
}
