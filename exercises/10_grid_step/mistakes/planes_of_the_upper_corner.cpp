// hint: sign
// The three planes through the upper corner of the cell are ahead of each ray, and the step follows the direction.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const Vec3d corner = grid.low + grid.side * Vec3d(cell[0] + 1, cell[1] + 1, cell[2] + 1);
    const Vec3d way = corner - ray.origin;
    std::vector<std::pair<double, int>> reached;
    for (int axis = 0; axis < 3; ++axis)
        if (ray.direction[axis] != 0) reached.emplace_back(way[axis] / ray.direction[axis], axis);
    const auto [t, axis] = *std::min_element(reached.begin(), reached.end());
    if (t > ray.range.max) return std::nullopt;
    Cell next = cell;
    int& place = next[static_cast<std::size_t>(axis)];
    place += ray.direction[axis] < 0 ? -1 : 1;
    if (place < 0 || place >= grid.cells[static_cast<std::size_t>(axis)]) return std::nullopt;
    return next;
}
