// hint: beyond_its_row
// or: only_squares
// Goes from a cell to its row by one share, and back by the other one: each floor loses something of its own.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const double cells = count, rows = std::floor(std::sqrt(cells));
    const double row = std::floor(cell * rows / cells);
    const double begin = std::floor(row * cells / rows), end = std::floor((row + 1) * cells / rows);
    const double width = 1 / (end - begin), low = begin / cells, high = end / cells;
    const double below_one = std::nextafter(1.0, 0.0);
    return {std::min((cell - begin) * width + u * width, below_one), std::min(std::lerp(low, high, v), below_one)};
}
