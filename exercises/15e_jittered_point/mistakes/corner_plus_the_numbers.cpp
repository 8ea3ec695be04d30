// hint: jitter_large
// Climbs row by row to the cell's corner, and adds the two numbers to it, which are as large as the square.
#include "raylab/sampling/pattern/jittered_point.h"

#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count))));
    std::array<double, 2> point{u, v};
    std::uint32_t place = cell, row = 0;
    const auto columns = [&] { return row < count % rows ? count / rows + 1 : count / rows; };
    for (; place >= columns(); ++row) {
        place -= columns();
        point[1] += static_cast<double>(columns()) / count;
    }
    point[0] += static_cast<double>(place) / columns();
    return point;
}
