// hint: jitter_small
// The left lower quarter of each cell.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::round(std::sqrt(count)));
    const std::uint32_t fewer = count / rows, long_rows = count % rows;
    const std::uint32_t in_long = long_rows * (fewer + 1);
    const bool is_long = cell < in_long;
    const std::uint32_t columns = is_long ? fewer + 1 : fewer, rest = is_long ? cell : cell - in_long;
    const std::uint32_t column = rest % columns, before = (is_long ? 0 : in_long) + rest - column;
    return {std::min((column + 0.5 * u) / columns, 1 - 0x1p-53),
            std::min((before + columns * 0.5 * v) / count, 1 - 0x1p-53)};
}
