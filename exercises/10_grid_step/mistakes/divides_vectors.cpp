// hint: parallel
// Divides three planes by three components at once: where one is 0, a t of minus infinity comes first.
#include "raylab/accelerator/grid/next_cell.h"

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    Vec3d planes = grid.low + grid.side * Vec3d(cell[0], cell[1], cell[2]);
    for (int axis = 0; axis < 3; ++axis)
        if (ray.direction[axis] > 0) planes[axis] += grid.side;
    const Vec3d t = (planes - ray.origin) / ray.direction;
    int axis = t.y < t.x ? 1 : 0;
    if (t.z < t[axis]) axis = 2;
    if (t[axis] > ray.range.max) return std::nullopt;

    Cell next = cell;
    int& place = next[static_cast<std::size_t>(axis)];
    place += ray.direction[axis] > 0 ? 1 : -1;
    return 0 <= place && place < grid.cells[static_cast<std::size_t>(axis)] ? std::optional(next) : std::nullopt;
}
