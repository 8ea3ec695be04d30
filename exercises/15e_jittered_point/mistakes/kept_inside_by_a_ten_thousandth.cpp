// hint: cut_too_early
// or: jitter_small
// Keeps the point a ten-thousandth below 1, where the next double would do.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    std::uint32_t rows = 1, place = cell, first = 0;
    while ((rows + 1) * (rows + 1) <= count) ++rows;
    const auto inside = [](double coordinate) { return std::clamp(coordinate, 0.0, 1 - 1e-4); };
    for (std::uint32_t row = 0;; ++row) {
        const std::uint32_t columns = count / rows + (row < count % rows ? 1 : 0);
        if (place < columns) return {inside((place + u) / columns), inside((first + v * columns) / count)};
        place -= columns;
        first += columns;
    }
}
