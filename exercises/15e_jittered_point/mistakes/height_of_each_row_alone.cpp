// hint: overlapping
// Goes through the rows, takes their cells away, and places a row by its number alone, though they differ in height.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    std::uint32_t rows = 1, row = 0, column = cell;
    while ((rows + 1) * (rows + 1) <= count) ++rows;
    const std::uint32_t few = count / rows, rest = count - few * rows;
    std::uint32_t columns = rest > 0 ? few + 1 : few;
    while (column >= columns) {
        column -= columns;
        columns = ++row < rest ? few + 1 : few;
    }
    const double below_one = std::nextafter(1.0, 0.0), share = static_cast<double>(columns) / count;
    return {std::min((column + u) / columns, below_one), std::min(1.0 * row / rows + share * v, below_one)};
}
