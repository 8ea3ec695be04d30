// hint: unequal_areas
// Makes a table of how many cells each row has, and divides the square's height by the number of rows all the same.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto most = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    std::vector<std::uint32_t> lengths(count / most, most);
    if (count % most != 0) lengths.push_back(count % most);
    std::size_t row = 0;
    std::uint32_t column = cell;
    while (column >= lengths[row]) column -= lengths[row++];
    const double height = 1.0 / static_cast<double>(lengths.size()), below_one = std::nextafter(1.0, 0.0);
    return {std::min((column + u) / lengths[row], below_one),
            std::min(height * (static_cast<double>(row) + v), below_one)};
}
