// hint: jitter_large
// About the middle of the cell, and twice as far.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const int n = static_cast<int>(count), rows = std::max(1, static_cast<int>(std::sqrt(n)));
    int row = 0;
    while (static_cast<int>(cell) >= (row + 1) * n / rows) ++row;
    const int first = row * n / rows, columns = (row + 1) * n / rows - first, column = static_cast<int>(cell) - first;
    const double x = (column + 2 * u - 0.5) / columns, y = (first + (2 * v - 0.5) * columns) / n;
    return {x, y};
}
