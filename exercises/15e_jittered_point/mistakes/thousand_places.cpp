// hint: whole_steps
// Rounds the place in a cell to thousandths of its side.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    const std::uint32_t few = count / rows, rest = count % rows, in_first = (rows - rest) * few;
    const bool is_first = cell < in_first;
    const std::uint32_t columns = is_first ? few : few + 1, place = is_first ? cell : cell - in_first;
    const std::uint32_t before = (is_first ? 0 : in_first) + place / columns * columns;
    const double across = std::round(1000 * u) / 1000, up = std::round(1000 * v) / 1000;
    const double x = (place % columns + across) / columns, y = (before + up * columns) / count;
    return {std::min(x, 1 - 0x1p-53), std::min(y, 1 - 0x1p-53)};
}
