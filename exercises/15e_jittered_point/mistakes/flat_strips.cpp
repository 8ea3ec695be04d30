// hint: strips
// Strips from the left to the right.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const double height = 1.0 / count, y = height * cell + height * v;
    return {u, y < 1 ? y : std::nextafter(1.0, 0.0)};
}
