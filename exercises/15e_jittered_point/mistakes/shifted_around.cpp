// hint: cell_ignored
// or: row_and_column
// Each cell moves the points of the whole square around it.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const double x = u + cell * 0.618034, y = v + 1.0 * cell / count;
    return {x - std::floor(x), y - std::floor(y)};
}
