// hint: floats
// Keeps the point in a vec2, which has floats.
#include "raylab/sampling/pattern/jittered_point.h"

#include <cmath>

#include <glm/vec2.hpp>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count))));
    std::uint32_t place = cell, row = 0, columns = 0;
    for (;; ++row) {
        columns = row < count % rows ? count / rows + 1 : count / rows;
        if (place < columns) break;
        place -= columns;
    }
    const double x = (place + u) / columns, y = (cell - place + v * columns) / count;
    const glm::vec2 point(x, y);
    return {point.x, point.y};
}
