// hint: overlapping
// Each row is as high as its cells need, but begins where it would if all rows were of one height.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    const std::uint32_t fewer = count / rows, longer_rows = count % rows, in_longer = longer_rows * (fewer + 1);
    const bool is_longer = cell < in_longer;
    const std::uint32_t columns = is_longer ? fewer + 1 : fewer, place = is_longer ? cell : cell - in_longer;
    const std::uint32_t row = place / columns + (is_longer ? 0 : longer_rows);
    const double height = static_cast<double>(columns) / count, low = static_cast<double>(row) / rows;
    const double x = (place % columns + u) / columns, y = low + height * v;
    return {std::min(x, 1 - 0x1p-53), std::min(y, 1 - 0x1p-53)};
}
