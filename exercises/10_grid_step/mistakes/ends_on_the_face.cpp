// hint: end_of_ray
// A ray that ends on the face has not left.
#include "raylab/accelerator/grid/next_cell.h"

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    int first = -1;
    double first_t = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double d = ray.direction[axis];
        if (d == 0) continue;
        const int ahead = cell[i] + (d > 0 ? 1 : 0);
        const double t = ((grid.low[axis] + ahead * grid.side) - ray.origin[axis]) / d;
        if (first >= 0 && t >= first_t) continue;
        first = axis;
        first_t = t;
    }
    if (first < 0 || first_t >= ray.range.max) return std::nullopt;
    Cell next = cell;
    const auto i = static_cast<std::size_t>(first);
    next[i] += ray.direction[first] > 0 ? 1 : -1;
    if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    return next;
}
