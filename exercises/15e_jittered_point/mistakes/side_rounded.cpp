// hint: only_squares
// or: empty_cells
// The root of the count, rounded to the nearest.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const int side = static_cast<int>(std::lround(std::sqrt(count)));
    const int row = static_cast<int>(cell) / side, column = static_cast<int>(cell) % side;
    const double x = (column + u) / side, y = (row + v) / side;
    return {std::min(x, 1 - 0x1p-53), row < side ? std::min(y, 1 - 0x1p-53) : y};
}
