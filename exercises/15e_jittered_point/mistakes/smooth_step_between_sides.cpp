// hint: not_uniform
// Goes from the left side to the right one by a smooth step, which is slow near both: the points crowd there.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count))));
    const std::uint32_t few = count / rows, rest = count % rows;
    // One of two divisions finds the row, and the other one comes out smaller.
    const std::uint32_t row = std::max(cell / (few + 1), cell < rest ? 0 : (cell - rest) / few);
    const std::uint32_t columns = row < rest ? few + 1 : few, first = row * few + std::min(row, rest);
    const double left = cell - first, low = first;
    const double x = (left + glm::smoothstep(0.0, 1.0, u)) / columns;
    const double y = glm::mix(low, low + columns, v) / count;
    return {std::min(x, 1 - 0x1p-53), std::min(y, 1 - 0x1p-53)};
}
