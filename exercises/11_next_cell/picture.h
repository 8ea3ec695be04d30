#pragma once

#include "exercise.h"
#include "raylab/geometry/vector.h"

#include <cmath>
#include <cstdint>

// A patchwork of cells of all sizes: a ray starts at each pixel, up to the right, and the pixel has the colour of the
// cell that comes next by the answer.

namespace raylab::grading::next_cell {

inline constexpr int width = 240, height = 180, widest = 6,
                     narrowest = 2;  // cells are 2^narrowest to 2^widest pixels wide

inline std::uint32_t scattered(int x, int y, int level) {
    const auto u = [](int i) { return static_cast<std::uint32_t>(i); };
    std::uint32_t bits = u(x) * 73856093u ^ u(y) * 19349663u ^ u(level) * 83492791u;
    bits = (bits ^ (bits >> 13)) * 0x5bd1e995u;
    return bits ^ (bits >> 15);
}

struct Patch {
    int x, y, level;  // in units of its own size; 2^level pixels wide
};

// The cell of a point, from the largest downward: two of three cells are divided.
inline Patch patch_at(double x, double y) {
    for (int level = widest;; --level) {
        const double side = std::ldexp(1.0, level);
        const Patch patch{static_cast<int>(std::floor(x / side)), static_cast<int>(std::floor(y / side)), level};
        if (level == narrowest || scattered(patch.x, patch.y, level) % 3 == 0) return patch;
    }
}

inline std::vector<Case> pixel_cases(int column, int row) {
    const double x = column + 0.5, y = height - row - 0.5;
    const Patch patch = patch_at(x, y);
    const double side = std::ldexp(1.0, patch.level);
    return {{"",
             Case::Kind::graded,
             {patch.x * side, patch.y * side, 0, side, std::ldexp(1.0, narrowest), x, y, 1.0, 1, 0.6180339887, 0}}};
}

inline Pixel shade(int, int, std::span<const double> answer) {
    if (!(std::abs(answer[0]) < 1e6 && std::abs(answer[1]) < 1e6)) return {0, 0, 0};
    const Patch next = patch_at(answer[0], answer[1]);
    const std::uint32_t bits = scattered(next.x, next.y, 40 + next.level);
    const auto part = [&](int shift) { return 0.15f + 0.75f * static_cast<float>((bits >> shift) & 255) / 255; };
    return {part(0), part(8), part(16)};
}

inline Picture patchwork_picture() {
    return {.about = "each pixel in the colour of the cell that comes next, up to the right",
            .width = width,
            .height = height,
            .cases = pixel_cases,
            .shade = shade};
}

}  // namespace raylab::grading::next_cell
