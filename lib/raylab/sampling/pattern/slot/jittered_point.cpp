#include "raylab/sampling/pattern/jittered_point.h"

#include "raylab/sampling/pattern/fraction.h"

#include <cmath>

// Rows with equally many cells, where some have one cell more and are higher by it.
std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)) + 0.5);
    const std::uint32_t fewer = count / rows;
    const std::uint32_t in_longer_rows = (count - fewer * rows) * (fewer + 1);
    const bool longer = cell < in_longer_rows;
    const std::uint32_t columns = longer ? fewer + 1 : fewer;
    const std::uint32_t before = longer ? 0 : in_longer_rows;  // cells in rows of the other length
    const std::uint32_t row = (cell - before) / columns, column = (cell - before) - row * columns;
    return {in_cell(column, u, columns), in_cell(before + row * columns, columns * v, count)};
}
