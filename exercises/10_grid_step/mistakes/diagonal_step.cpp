// hint: one_face
// Crosses all faces that are reached at the smallest t: at an edge, two.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    Vec3d t(std::numeric_limits<double>::infinity());
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        const int ahead = cell[static_cast<std::size_t>(axis)] + (d > 0 ? 1 : 0);
        if (d != 0) t[axis] = ((grid.low[axis] + ahead * grid.side) - ray.origin[axis]) / d;
    }
    const double first = std::min({t.x, t.y, t.z});
    if (first > ray.range.max) return std::nullopt;
    Cell next = cell;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        if (t[axis] == first) next[i] += ray.direction[axis] > 0 ? 1 : -1;
        if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    }
    return next;
}
