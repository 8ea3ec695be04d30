// hint: one_number
// Every point is half as high as its row.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double) {
    const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count))));
    const std::uint32_t fewer = count / rows, in_longer = count % rows * (fewer + 1);
    const std::uint32_t columns = cell < in_longer ? fewer + 1 : fewer;
    const std::uint32_t column = (cell < in_longer ? cell : cell - in_longer) % columns;
    const double y = (cell - column + 0.5 * columns) / count;
    return {std::min((column + u) / columns, 1 - 0x1p-53), y};
}
