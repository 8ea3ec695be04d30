// As many full rows as there are, and what is left is shared out among the last ones.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const double n = count, below_one = std::nextafter(1.0, 0.0);
    const auto rows = static_cast<std::uint32_t>(std::ceil(std::sqrt(n) - 0.5));
    std::uint32_t before = 0;
    for (std::uint32_t row = 0;; ++row) {
        const std::uint32_t columns = count / rows + (row >= rows - count % rows ? 1 : 0);
        if (cell < before + columns)
            return {std::min((cell - before + u) / columns, below_one),
                    std::min(before / n + v * columns / n, below_one)};
        before += columns;
    }
}
