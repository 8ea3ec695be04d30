// hint: floats
// The point is rounded to floats.
#include "raylab/sampling/pattern/jittered_point.h"

#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::round(std::sqrt(count)));
    const std::uint32_t fewer = count / rows, in_long = count % rows * (fewer + 1);
    const std::uint32_t columns = cell < in_long ? fewer + 1 : fewer, rest = cell < in_long ? cell : cell - in_long;
    const std::uint32_t column = rest % columns, before = cell - column;
    const auto x = static_cast<float>((column + u) / columns), y = static_cast<float>((before + columns * v) / count);
    return {x, y};
}
