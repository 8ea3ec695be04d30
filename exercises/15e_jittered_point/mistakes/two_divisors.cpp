// hint: row_and_column
// or: only_squares
// The column is the rest of one division, the row the quotient of another.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::round(std::sqrt(count)));
    const std::uint32_t columns = (count + rows - 1) / rows;
    const double x = (cell % columns + u) / columns, y = (cell / (columns + 1) + v) / rows;
    return {std::min(x, 1 - 0x1p-53), std::min(y, 1 - 0x1p-53)};
}
