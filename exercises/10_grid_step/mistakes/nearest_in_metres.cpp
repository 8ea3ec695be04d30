// hint: nearest_plane
// Compares how many metres off the planes stand along their axes, and not when they are reached.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::size_t first = 3;
    double least = std::numeric_limits<double>::infinity(), t = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const double d = ray.direction[i];
        if (d == 0) continue;
        const double away = grid.low[i] + (cell[axis] + (d > 0)) * grid.side - ray.origin[i];
        if (std::abs(away) >= least) continue;
        least = std::abs(away);
        first = axis;
        t = away / d;
    }
    if (first == 3 || t > ray.range.max) return std::nullopt;
    Cell next = cell;
    next[first] += ray.direction[static_cast<int>(first)] > 0 ? 1 : -1;
    if (next[first] < 0 || next[first] >= grid.cells[first]) return std::nullopt;
    return next;
}
