#pragma once

#include "number_pairs.h"

#include "raylab/image/draw.h"

#include <array>
#include <cmath>
#include <vector>

// Drawings of what a function made of pairs of numbers.

namespace raylab::grading {

inline constexpr Pixel paper{1, 1, 1};

/// The pairs of a case that are drawn as dots: one in each second cell of the square, both ways, which is one for 16.
inline std::vector<std::size_t> drawn_pairs() {
    std::vector<std::size_t> all;
    for (std::size_t row = 0; row < strata; row += 2)
        for (std::size_t column = 0; column < strata; column += 2) all.push_back(2 * (row * strata + column));
    return all;
}

/// A dot in the colour of its first number's quarter of [0, 1): where a function sends neighbours.
inline void draw_dot(Image& image, Point2 at, const NumberPair& numbers) {
    constexpr double far_away = 1e4;  // pixels; also what is no number is not drawn
    if (!(std::abs(at.x) < far_away && std::abs(at.y) < far_away)) return;
    const std::array inks{ink::blue, ink::sky_blue, ink::orange, ink::vermilion};
    draw_disk(image, at, 2.2, inks[static_cast<std::size_t>(std::min(numbers.u, 1 - 0x1p-53) * inks.size())]);
}

/// A filled rectangle.
inline void fill_bar(Image& image, Point2 from, Point2 to, const Pixel& color) {
    fill_convex(image, {from, {to.x, from.y}, to, {from.x, to.y}}, color);
}

}  // namespace raylab::grading
