// hint: faces_by_tolerance
// or: one_face
// Crosses every face that is less than a tenth of a micrometre from the point where the ray leaves.
#include "raylab/accelerator/grid/next_cell.h"

#include <cmath>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    double t = std::numeric_limits<double>::infinity();
    Vec3d plane{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        if (d == 0) continue;
        const int ahead = cell[static_cast<std::size_t>(axis)] + (d > 0 ? 1 : 0);
        plane[axis] = grid.low[axis] + ahead * grid.side;
        t = std::fmin(t, (plane[axis] - ray.origin[axis]) / d);
    }
    if (t > ray.range.max) return std::nullopt;
    Cell next = cell;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis], place = ray.origin[axis] + t * d;
        const auto i = static_cast<std::size_t>(axis);
        if (d != 0 && std::fabs(place - plane[axis]) < 1e-7) next[i] += d > 0 ? 1 : -1;
        if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    }
    return next;
}
