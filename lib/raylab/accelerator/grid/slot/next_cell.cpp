#include "raylab/accelerator/grid/next_cell.h"

#include <cstddef>

// 3D-DDA without state: of the three faces ahead, the ray leaves through the one that it reaches first (Amanatides and
// Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, Eurographics 1987). Each t is computed from the plane itself,
// so that no error accumulates from step to step.
std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    std::optional<std::size_t> first;
    double first_t = ray.range.max;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        if (ray.direction[i] == 0) continue;  // the ray never reaches a face of this axis
        const int ahead = cell[axis] + (ray.direction[i] > 0 ? 1 : 0);
        const double t = (grid.low[i] + ahead * grid.side - ray.origin[i]) / ray.direction[i];
        if (t > first_t || (first && t == first_t)) continue;
        first = axis;
        first_t = t;
    }
    if (!first) return std::nullopt;
    Cell next = cell;
    next[*first] += ray.direction[static_cast<int>(*first)] > 0 ? 1 : -1;
    const bool inside = next[*first] >= 0 && next[*first] < grid.cells[*first];
    return inside ? std::optional(next) : std::nullopt;
}
