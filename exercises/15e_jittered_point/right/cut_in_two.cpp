// Cuts the square in two parts with half of the cells each, and so on.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    double left = 0, low = 0, width = 1, height = 1;
    for (std::uint32_t first = 0, cells = count; cells > 1;) {
        const std::uint32_t half = cells / 2;
        const bool upper = cell - first >= half;
        const double share = 1.0 * half / cells, kept = upper ? 1 - share : share;
        double &start = width >= height ? left : low, &size = width >= height ? width : height;
        start += upper ? share * size : 0;
        size *= kept;
        first += upper ? half : 0;
        cells = upper ? cells - half : half;
    }
    const double below_one = std::nextafter(1.0, 0.0);
    return {std::min(left + u * width, below_one), std::min(low + v * height, below_one)};
}
