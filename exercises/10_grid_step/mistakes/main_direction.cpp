// hint: longest_component
// The axis of the largest component.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const Vec3d s{std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)};
    const int axis = s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
    const int plane = cell[static_cast<std::size_t>(axis)] + (ray.direction[axis] > 0 ? 1 : 0);
    if ((grid.low[axis] + plane * grid.side - ray.origin[axis]) / ray.direction[axis] > ray.range.max)
        return std::nullopt;

    Cell out = cell;
    int& c = out[static_cast<std::size_t>(axis)];
    c += ray.direction[axis] > 0 ? 1 : -1;
    if (c < 0 || c >= grid.cells[static_cast<std::size_t>(axis)]) return std::nullopt;
    return out;
}
