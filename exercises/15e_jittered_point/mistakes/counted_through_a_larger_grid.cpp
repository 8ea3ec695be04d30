// hint: empty_cells
// Counts through the smallest square grid that has room for all cells, and stops before it has been everywhere.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    std::uint32_t side = 1, column = 0, row = 0;
    while (side * side < count) ++side;
    for (std::uint32_t i = 0; i < cell; ++i)
        if (++column == side) {
            column = 0;
            ++row;
        }
    const double width = 1.0 / side, below_one = std::nextafter(1.0, 0.0);
    return {std::min(width * column + width * u, below_one), std::min(width * row + width * v, below_one)};
}
