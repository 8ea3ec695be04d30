// hint: one_face
// All axes at the smallest t.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <array>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::array<double, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<int>(i);
        const double d = ray.direction[k];
        t[i] = d == 0 ? 1e300 : (grid.low[k] + (cell[i] + (d > 0)) * grid.side - ray.origin[k]) / d;
    }
    const double first = *std::min_element(t.begin(), t.end());
    if (first > ray.range.max) return std::nullopt;
    Cell out = cell;
    for (std::size_t i = 0; i < 3; ++i)
        if (t[i] <= first) {
            out[i] += ray.direction[static_cast<int>(i)] > 0 ? 1 : -1;
            if (out[i] < 0 || out[i] >= grid.cells[i]) return std::nullopt;
        }
    return out;
}
