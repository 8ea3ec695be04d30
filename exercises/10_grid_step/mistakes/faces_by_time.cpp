// hint: faces_by_tolerance
// or: one_face
// Crosses every face that is reached within a millionth of the first one's t.
#include "raylab/accelerator/grid/next_cell.h"

#include <array>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::array<double, 3> t{};
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        const double way = ray.direction[axis];
        const double plane = grid.low[axis] + (way > 0 ? cell[i] + 1 : cell[i]) * grid.side;
        t[i] = way == 0 ? std::numeric_limits<double>::infinity() : (plane - ray.origin[axis]) / way;
        if (t[i] < first) first = t[i];
    }
    if (first > ray.range.max) return std::nullopt;
    Cell next = cell;
    for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] > first + 1e-6) continue;
        next[i] += ray.direction[static_cast<int>(i)] > 0 ? 1 : -1;
        if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    }
    return next;
}
