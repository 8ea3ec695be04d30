// hint: unequal_areas
// Looks the row up among the first cells of all rows. Where more cells are in it, it should be higher, too.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    std::vector<std::uint32_t> begins;
    for (std::uint32_t row = 0; row <= rows; ++row) begins.push_back(row * count / rows);
    const auto end = std::ranges::upper_bound(begins, cell), begin = end - 1;
    const double x = (cell - *begin + u) / (*end - *begin);
    const double y = (static_cast<double>(begin - begins.begin()) + v) / rows;
    return {std::min(x, 1 - 0x1p-53), std::min(y, 1 - 0x1p-53)};
}
