// hint: not_ahead
// Takes only planes that are reached after t = 0: what begins on the face by which it leaves goes nowhere.
#include "raylab/accelerator/grid/next_cell.h"

#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    double least = std::numeric_limits<double>::infinity();
    std::optional<Cell> next;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        const double way = ray.direction[axis];
        if (way == 0) continue;
        const double plane = grid.low[axis] + (way > 0 ? cell[i] + 1 : cell[i]) * grid.side;
        const double t = (plane - ray.origin[axis]) / way;
        if (t <= 0 || t >= least) continue;
        least = t;
        next = cell;
        (*next)[i] += way > 0 ? 1 : -1;
        if ((*next)[i] < 0 || (*next)[i] >= grid.cells[i]) next.reset();
    }
    return least <= ray.range.max ? next : std::nullopt;
}
