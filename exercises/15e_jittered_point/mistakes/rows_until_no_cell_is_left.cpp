// hint: strips
// Fills one row after another while there are cells. The last row may get a single one, as long as the square.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
    std::uint32_t left = count, place = cell;
    double low = 0, height = static_cast<double>(columns) / count;
    while (place >= columns) {
        place -= columns;
        left -= columns;
        low += height;
        columns = std::min(columns, left);
        height = static_cast<double>(columns) / count;
    }
    const double below_one = std::nextafter(1.0, 0.0);
    return {std::min((place + u) / columns, below_one), std::min(low + v * height, below_one)};
}
