// hint: shifted
// From the middle of its cell to the middle of the next one.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    std::uint32_t first = 0, row = 0;
    const auto cells_in = [&](std::uint32_t r) { return count / rows + (r < count % rows ? 1 : 0); };
    while (cell >= first + cells_in(row)) first += cells_in(row++);
    const double width = 1.0 / cells_in(row), height = static_cast<double>(cells_in(row)) / count;
    return {(cell - first + 0.5 + u) * width, 1.0 * first / count + (0.5 + v) * height};
}
