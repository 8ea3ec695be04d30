// hint: end_of_ray
// Makes the direction one long, so that each t is in metres, and compares it with the range as it was given.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const Vec3d way = ray.direction / glm::length(ray.direction);
    std::vector<std::pair<double, std::size_t>> planes;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<int>(i);
        const double low = grid.low[k] + cell[i] * grid.side;
        if (way[k] > 0) planes.emplace_back((low + grid.side - ray.origin[k]) / way[k], i);
        if (way[k] < 0) planes.emplace_back((low - ray.origin[k]) / way[k], i);
    }
    const auto [metres, axis] = *std::min_element(planes.begin(), planes.end());
    if (metres > ray.range.max) return std::nullopt;
    Cell next = cell;
    next[axis] += way[static_cast<int>(axis)] > 0 ? 1 : -1;
    return next[axis] < 0 || next[axis] >= grid.cells[axis] ? std::nullopt : std::optional(next);
}
