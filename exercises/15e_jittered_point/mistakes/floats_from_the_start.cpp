// hint: floats
// Every number is a float.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto strips = static_cast<std::uint32_t>(std::sqrt(static_cast<float>(count)));
    std::uint32_t first = 0, strip = 0;
    const auto cells_in = [&](std::uint32_t s) { return count / strips + (s < count % strips ? 1 : 0); };
    while (cell >= first + cells_in(strip)) first += cells_in(strip++);
    const auto cells = static_cast<float>(cells_in(strip)), all = static_cast<float>(count);
    const float x = (static_cast<float>(first) + cells * static_cast<float>(u)) / all;
    const float y = (static_cast<float>(cell - first) + static_cast<float>(v)) / cells;
    return {std::min(x, 0x1.fffffep-1F), std::min(y, 0x1.fffffep-1F)};
}
