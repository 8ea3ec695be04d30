// Pairs of t and axis, sorted.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::vector<std::pair<double, std::size_t>> planes;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<int>(i);
        const double d = ray.direction[k], low = grid.low[k] + cell[i] * grid.side;
        if (d > 0) planes.emplace_back((low + grid.side - ray.origin[k]) / d, i);
        if (d < 0) planes.emplace_back((low - ray.origin[k]) / d, i);
    }
    const auto [t, axis] = *std::min_element(planes.begin(), planes.end());
    if (t > ray.range.max) return std::nullopt;
    Cell out = cell;
    out[axis] += ray.direction[static_cast<int>(axis)] > 0 ? 1 : -1;
    return out[axis] < 0 || out[axis] >= grid.cells[axis] ? std::nullopt : std::optional(out);
}
