#pragma once

#include "raylab/accelerator/grid/next_cell.h"
#include "raylab/geometry/box.h"
#include "raylab/geometry/reaches_box.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// Where a uniform grid cuts space, as exact numbers: the planes are the doubles that stand here, not what they were
/// computed from. The outermost planes lie `slack` beyond the boxes.
struct GridPlanes {
    std::array<std::vector<double>, 3> along;  // ascending; one more than cells
    /// How much a box is grown before it is told into which cells it reaches, and what rounding may move a ray by.
    double slack = 0;

    int cells(int axis) const { return static_cast<int>(along[static_cast<std::size_t>(axis)].size()) - 1; }
    std::size_t cell_count() const;
    std::size_t index(const Cell& cell) const;
    Cell cell(std::size_t index) const;
    std::size_t bytes() const;

    /// The outermost cells count as endless.
    int cell_at(int axis, double coordinate) const;
    Box bounds(const Cell& cell) const;
    /// Grown by 2 slack: one for the walk, one for whoever computes with it.
    BoxOfDoubles grown(const Cell& cell) const;

    /// The first and the last cell that a box, grown by `slack`, reaches into.
    struct Range {
        Cell first, last;
        std::size_t size() const;
    };
    Range reached(const Box& box) const;

    /// Whether there is a grid: none is made of nothing, of a point, or where doubles could not tell its cells apart.
    bool exist() const { return slack > 0; }
};

/// `density` cells a box, as nearly cubes as may be; fewer where that would be more than 2^22 + 64 a box, or where boxes would
/// reach into more.
GridPlanes grid_planes(std::span<const Box> boxes, double density);

}  // namespace raylab
