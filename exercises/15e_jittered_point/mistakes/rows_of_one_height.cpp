// hint: unequal_areas
// Rows of different lengths, and all of one height.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const double below_one = std::nextafter(1.0, 0.0);
    const int n = static_cast<int>(count), rows = std::max(1, static_cast<int>(std::sqrt(n)));
    int row = 0;
    while (static_cast<int>(cell) >= (row + 1) * n / rows) ++row;
    const int first = row * n / rows, columns = (row + 1) * n / rows - first, column = static_cast<int>(cell) - first;
    const double x = (column + u) / columns, y = (row + v) / rows;
    return {std::min(x, below_one), std::min(y, below_one)};
}
