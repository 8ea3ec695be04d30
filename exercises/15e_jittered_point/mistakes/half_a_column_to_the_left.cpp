// hint: shifted
// The jitter goes from -1/2 to 1/2, about the cell's side and not about its middle.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::round(std::sqrt(count)));
    const std::uint32_t fewer = count / rows, in_long = count % rows * (fewer + 1);
    const std::uint32_t columns = cell < in_long ? fewer + 1 : fewer, rest = cell < in_long ? cell : cell - in_long;
    const std::uint32_t column = rest % columns, before = cell - column;
    return {(column + u - 0.5) / columns, std::min((before + columns * v) / count, 1 - 0x1p-53)};
}
