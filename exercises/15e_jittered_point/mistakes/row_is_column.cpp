// hint: row_and_column
// The row is the column.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
    return {std::min((cell % side + u) / side, 1 - 0x1p-53), std::min((cell % side + v) / side, 1 - 0x1p-53)};
}
