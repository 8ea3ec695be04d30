// hint: small_is_not_zero
// or: missing
// Takes each component of less than a millionth for 0.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::size_t first = 3;
    double t = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const double d = ray.direction[i];
        if (std::abs(d) < 1e-6) continue;
        const double reached = (grid.low[i] + (cell[axis] + (d > 0)) * grid.side - ray.origin[i]) / d;
        if (reached < t) t = reached, first = axis;
    }
    if (first == 3 || t > ray.range.max) return std::nullopt;
    Cell next = cell;
    next[first] += ray.direction[static_cast<int>(first)] > 0 ? 1 : -1;
    if (next[first] < 0 || next[first] >= grid.cells[first]) return std::nullopt;
    return next;
}
