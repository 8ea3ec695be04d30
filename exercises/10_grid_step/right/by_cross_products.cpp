// Without a division: a / b < c / d is a d < c b where b and d are positive.
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
    if (first < 0 || way[first] > ray.range.max * speed[first]) return std::nullopt;
    Cell next = cell;
    int& place = next[static_cast<std::size_t>(first)];
    place += ray.direction[first] > 0 ? 1 : -1;
    return 0 <= place && place < grid.cells[static_cast<std::size_t>(first)] ? std::optional(next) : std::nullopt;
}
