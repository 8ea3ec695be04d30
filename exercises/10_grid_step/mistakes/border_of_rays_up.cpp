// hint: end_of_grid
// Asks for the border where the ray goes up, and steps down without asking.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    Vec3d way{}, speed{};  // to the plane ahead, and towards it
    for (int axis = 0; axis < 3; ++axis) {
        speed[axis] = std::abs(ray.direction[axis]);
        const int k = cell[static_cast<std::size_t>(axis)];
        way[axis] = ray.direction[axis] > 0 ? grid.low[axis] + (k + 1) * grid.side - ray.origin[axis]
                                            : ray.origin[axis] - grid.low[axis] - k * grid.side;
    }
    int first = -1;
    for (int axis = 0; axis < 3; ++axis)
        if (speed[axis] > 0 && (first < 0 || way[axis] * speed[first] < way[first] * speed[axis])) first = axis;
    if (way[first] > ray.range.max * speed[first]) return std::nullopt;

    Cell next = cell;
    const auto i = static_cast<std::size_t>(first);
    if (ray.direction[first] < 0) {
        --next[i];
        return next;
    }
    ++next[i];
    return next[i] < grid.cells[i] ? std::optional(next) : std::nullopt;
}
