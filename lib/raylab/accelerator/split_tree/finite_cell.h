#pragma once

#include "raylab/geometry/bounds/box.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace raylab {

/// The box clamped to the largest floats, so that a splitting rule can compute its area.
inline Box finite(const Box& box) {
    constexpr float largest = std::numeric_limits<float>::max();
    return {glm::max(box.min, Vec3f(-largest)), glm::min(box.max, Vec3f(largest))};
}

inline Vec3d size(const Box& box) { return convert<double>(box.max) - convert<double>(box.min); }

/// The axes sorted by the length of the box along them, the longest first; of equal ones the lower axis comes first.
inline std::array<std::size_t, 3> longest_first(const Box& box) {
    std::array<std::size_t, 3> axes{0, 1, 2};
    const Vec3d length = size(box);
    std::ranges::stable_sort(
        axes, [&](std::size_t a, std::size_t b) { return length[static_cast<int>(a)] > length[static_cast<int>(b)]; });
    return axes;
}

}  // namespace raylab
