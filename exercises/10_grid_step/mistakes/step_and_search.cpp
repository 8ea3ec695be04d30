// hint: step_and_search
// Goes a cell's side from where the ray is nearest to the cell's middle, and looks where it is.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const Vec3d middle = grid.low + Vec3d{cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5} * grid.side;
    const double here = dot(middle - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
    const double t = here + grid.side / glm::length(ray.direction);
    if (t > ray.range.max) return std::nullopt;
    Cell next{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        next[i] =
            static_cast<int>(std::floor((ray.origin[axis] + t * ray.direction[axis] - grid.low[axis]) / grid.side));
        if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    }
    return next;
}
