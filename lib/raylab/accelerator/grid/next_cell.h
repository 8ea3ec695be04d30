#pragma once

#include "raylab/geometry/ray.h"

#include <array>
#include <optional>

namespace raylab {

/// A cell of a grid by its place on each axis, from 0.
using Cell = std::array<int, 3>;

/// Equal cells side by side: cell (i, j, k) reaches from low + (i, j, k) * side to low + (i + 1, j + 1, k + 1) * side.
struct UniformGrid {
    Vec3d low;
    double side;
    Cell cells;  // how many along each axis
};

/// Where the ray goes from `cell`, in which some of it lies, as t grows: into a neighbour across one face; absent where it
/// leaves the grid or its range ends before. This is the slot of exercise 10.
std::optional<Cell> next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell);

}  // namespace raylab
