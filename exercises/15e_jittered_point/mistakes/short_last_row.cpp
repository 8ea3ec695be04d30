// hint: strips
// The last row has what is left over, in cells that are as much longer.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    std::uint32_t columns = 1;
    while (columns * columns < count) ++columns;
    const std::uint32_t before = cell / columns * columns, in_row = std::min(columns, count - before);
    const double x = (cell - before + u) / in_row, y = (before + in_row * v) / count;
    return {std::min(x, 1 - 0x1p-53), std::min(y, 1 - 0x1p-53)};
}
