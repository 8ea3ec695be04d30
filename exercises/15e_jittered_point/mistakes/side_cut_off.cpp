// hint: only_squares
// As many columns and rows as the root of the count, cut off.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto side = static_cast<std::uint32_t>(std::sqrt(count));
    const double x = (cell % side + u) / side, y = (cell / side + v) / side;
    return {std::min(x, 1 - 0x1p-53), cell < side * side ? std::min(y, 1 - 0x1p-53) : y};
}
