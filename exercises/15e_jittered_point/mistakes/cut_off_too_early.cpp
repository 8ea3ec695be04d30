// hint: cut_too_early
// or: jitter_small
// Cuts coordinates off at 0.9999, far below 1.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    const auto rows = static_cast<std::uint32_t>(std::sqrt(count));
    const std::uint32_t longer = count % rows, columns = count / rows, in_longer = longer * (columns + 1);
    const bool is_longer = cell < in_longer;
    const std::uint32_t wide = columns + is_longer, from = is_longer ? 0 : in_longer;
    const std::uint32_t first = from + (cell - from) / wide * wide;
    return {std::min(0.9999, (cell - first + u) / wide), std::min(0.9999, (first + v * wide) / count)};
}
