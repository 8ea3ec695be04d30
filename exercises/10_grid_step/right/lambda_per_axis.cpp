// A lambda for each axis, and the smallest of three.
#include "raylab/accelerator/grid/next_cell.h"

#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const auto reached = [&](std::size_t i) {
        const auto k = static_cast<int>(i);
        const double d = ray.direction[k];
        if (d == 0) return std::numeric_limits<double>::infinity();
        return (grid.low[k] + (d > 0 ? cell[i] + 1 : cell[i]) * grid.side - ray.origin[k]) / d;
    };
    std::size_t axis = reached(1) < reached(0) ? 1 : 0;
    if (reached(2) < reached(axis)) axis = 2;
    if (reached(axis) > ray.range.max) return std::nullopt;
    Cell out = cell;
    out[axis] += ray.direction[static_cast<int>(axis)] < 0 ? -1 : 1;
    if (out[axis] < 0 || out[axis] >= grid.cells[axis]) return std::nullopt;
    return out;
}
