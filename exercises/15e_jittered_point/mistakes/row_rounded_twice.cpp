// hint: beyond_its_row
// or: only_squares
// Rounds the row of a cell and the first cell of a row down, each by itself: they do not fit together.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::sqrt(count));
    const std::uint32_t row = cell * rows / count;
    const auto begin_of = [&](std::uint32_t r) { return r * count / rows; };
    const double begin = begin_of(row), columns = begin_of(row + 1) - begin;
    return {std::min(1 - 0x1p-53, (cell - begin + u) / columns), std::min(1 - 0x1p-53, (begin + v * columns) / count)};
}
