#pragma once

#include "raylab/geometry/ray.h"

#include <array>
#include <optional>

namespace raylab {

/// The indices of a grid cell along each axis, from 0.
using Cell = std::array<int, 3>;

/// Equal cells side by side: cell (i, j, k) reaches from low + (i, j, k) * side to low + (i + 1, j + 1, k + 1) * side.
struct UniformGrid {
    Vec3d low;
    double side;
    Cell cells;  // the number along each axis
};

/// The cell that the ray enters next from `cell`, in which some of it lies, as t grows: a neighbour across one face.
/// Absent where the ray leaves the grid or its range ends before that face; one that ends on it is long enough. Through
/// an edge or a corner each of the faces will do. This is the slot of exercise 10.
std::optional<Cell> next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell);

}  // namespace raylab
