// hint: rooks
// One point in each of count columns, and one in each of count rows.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <numeric>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    std::uint32_t apart = count / 3 + 1;
    while (std::gcd(apart, count) > 1) ++apart;
    const double column = cell, row = cell * apart % count;
    return {std::min(1 - 0x1p-53, (column + u) / count), std::min(1 - 0x1p-53, (row + v) / count)};
}
