// hint: sign
// Steps down where the ray goes up, and the other way round.
#include "raylab/accelerator/grid/next_cell.h"

#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::size_t first = 3;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<int>(i);
        if (ray.direction[k] == 0) continue;
        const int ahead = cell[i] + (ray.direction[k] > 0 ? 1 : 0);
        const double t = (grid.low[k] + ahead * grid.side - ray.origin[k]) / ray.direction[k];
        if (t < least) {
            least = t;
            first = i;
        }
    }
    if (first == 3 || least > ray.range.max) return std::nullopt;
    Cell next = cell;
    next[first] += ray.direction[static_cast<int>(first)] > 0 ? -1 : 1;
    if (next[first] < 0 || next[first] >= grid.cells[first]) return std::nullopt;
    return next;
}
