// hint: unequal_areas
// Cuts the square in two, and each part again, always in the middle: of three cells one is as large as both others.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    std::array<double, 2> low{0, 0}, side{1, 1};
    std::uint32_t first = 0, last = count;
    while (last - first > 1) {
        const std::size_t longer = side[0] < side[1] ? 1 : 0;
        const std::uint32_t middle = (first + last + 1) / 2;
        side[longer] *= 0.5;
        if (cell < middle) {
            last = middle;
        } else {
            first = middle;
            low[longer] += side[longer];
        }
    }
    return {std::min(low[0] + u * side[0], 1 - 0x1p-53), std::min(low[1] + v * side[1], 1 - 0x1p-53)};
}
