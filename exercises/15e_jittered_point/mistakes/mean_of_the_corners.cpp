// hint: always_one_point
// Finds the four sides of the cell, and returns the middle between them.
#include "raylab/sampling/pattern/jittered_point.h"

#include <cmath>
#include <numeric>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count))));
    std::uint32_t place = cell, longer_rows = count % rows;
    double low = 0;
    for (;;) {
        const std::uint32_t columns = longer_rows > 0 ? count / rows + 1 : count / rows;
        const double high = low + static_cast<double>(columns) / count;
        if (place < columns) {
            const double left = static_cast<double>(place) / columns, right = (place + 1.0) / columns;
            return {std::midpoint(left, right), std::midpoint(low, high)};
        }
        place -= columns;
        low = high;
        if (longer_rows > 0) --longer_rows;
    }
}
