// hint: unequal_areas
// Rows of one height; the last one has fewer cells, which are wider.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
    const std::uint32_t rows = (count + columns - 1) / columns, row = cell / columns;
    const std::uint32_t here = row + 1 < rows ? columns : count - row * columns;
    return {std::min((cell - row * columns + u) / here, 1 - 0x1p-53), std::min((row + v) / rows, 1 - 0x1p-53)};
}
