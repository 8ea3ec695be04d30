// hint: shifted
// Adds the jitter to the middle of the cell, where it belongs to its corner.
#include "raylab/sampling/pattern/jittered_point.h"

#include <cmath>

#include <glm/vec2.hpp>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::floor(std::sqrt(static_cast<double>(count))));
    const std::uint32_t few = count / rows, in_longer = count % rows * (few + 1);
    const std::uint32_t columns = cell < in_longer ? few + 1 : few;
    const std::uint32_t column = (cell < in_longer ? cell : cell - in_longer) % columns;
    const glm::dvec2 size{1.0 / columns, static_cast<double>(columns) / count};
    const glm::dvec2 corner{column * size.x, static_cast<double>(cell - column) / count};
    const glm::dvec2 middle = corner + 0.5 * size, point = middle + glm::dvec2{u, v} * size;
    return {point.x, point.y};
}
