// hint: depends_on_order
// Keeps the t of the first ray that it ever saw for all that follow.
#include "raylab/accelerator/grid/next_cell.h"

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    static const Vec3d inverse = 1.0 / ray.direction;
    int axis = 0;
    double best = 1e300;
    for (int i = 0; i < 3; ++i) {
        const int plane = cell[static_cast<std::size_t>(i)] + (ray.direction[i] > 0 ? 1 : 0);
        const double t = (grid.low[i] + plane * grid.side - ray.origin[i]) * inverse[i];
        if (ray.direction[i] != 0 && t < best) {
            best = t;
            axis = i;
        }
    }
    if (best > ray.range.max) return std::nullopt;

    Cell out = cell;
    int& c = out[static_cast<std::size_t>(axis)];
    c += ray.direction[axis] > 0 ? 1 : -1;
    if (c < 0 || c >= grid.cells[static_cast<std::size_t>(axis)]) return std::nullopt;
    return out;
}
