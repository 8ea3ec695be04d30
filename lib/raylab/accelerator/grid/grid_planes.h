#pragma once

#include "raylab/accelerator/grid/next_cell.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/bounds/reaches_box.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// The planes of a uniform grid, as exact numbers: a plane is the double that stands here, not the number it was
/// rounded from. The outermost planes lie `slack` beyond the boxes.
struct GridPlanes {
    std::array<std::vector<double>, 3> along;  // ascending, one more than there are cells
    /// how much a box is grown before its cells are determined; it bounds how far rounding may move a ray
    double slack = 0;

    int cells(int axis) const { return static_cast<int>(along[static_cast<std::size_t>(axis)].size()) - 1; }
    std::size_t cell_count() const;
    std::size_t index(const Cell& cell) const;
    Cell cell(std::size_t index) const;
    std::size_t bytes() const;

    /// The cell of a coordinate; the outermost cells reach to infinity.
    int cell_at(int axis, double coordinate) const;
    Box bounds(const Cell& cell) const;
    /// The cell grown by 2 slack: once for the traversal, once for the caller's own roundings.
    BoxOfDoubles grown(const Cell& cell) const;

    /// The first and the last cell that a box, grown by `slack`, reaches into.
    struct Range {
        Cell first, last;
        std::size_t size() const;
    };
    Range reached(const Box& box) const;

    /// Whether there is a grid. There is none without boxes, for a single point, or where doubles could not tell its
    /// cells apart.
    bool exist() const { return slack > 0; }
};

/// A grid of `density` cells for each box, as nearly cubes as possible. It has fewer cells where there would be more
/// than 2^22 + 64 for each box, or where boxes would have more entries than that.
GridPlanes grid_planes(std::span<const Box> boxes, double density);

}  // namespace raylab
