// hint: empty_cells
// Rows as long as the root, and as many as are needed.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const double n = count, columns = std::floor(std::sqrt(n)), rows = std::ceil(n / columns);
    const double row = std::floor(cell / columns), column = cell - row * columns;
    return {std::min((column + u) / columns, 1 - 0x1p-53), std::min((row + v) / rows, 1 - 0x1p-53)};
}
