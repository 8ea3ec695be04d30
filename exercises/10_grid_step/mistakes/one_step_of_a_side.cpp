// hint: step_and_search
// or: no_step
// A step as long as a cell is wide from the middle of the cell.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    Vec3d middle{};
    for (int i = 0; i < 3; ++i) middle[i] = grid.low[i] + (cell[static_cast<std::size_t>(i)] + 0.5) * grid.side;
    const Vec3d p = middle + grid.side * glm::normalize(ray.direction);
    Cell out{};
    for (int i = 0; i < 3; ++i) {
        const int c = static_cast<int>(std::floor((p[i] - grid.low[i]) / grid.side));
        if (c < 0 || c >= grid.cells[static_cast<std::size_t>(i)]) return std::nullopt;
        out[static_cast<std::size_t>(i)] = c;
    }
    return out;
}
