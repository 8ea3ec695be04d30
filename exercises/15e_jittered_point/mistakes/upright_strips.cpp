// hint: strips
// Strips from below to above.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    return {std::min((cell + u) / count, 1 - 0x1p-53), v};
}
