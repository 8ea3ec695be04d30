#pragma once

#include "number_pairs.h"

#include "raylab/sampling/mapping/lens_point.h"

#include <span>

namespace raylab::grading::lens {

inline constexpr std::size_t inputs = 2;           // the lens' radius, and which numbers
inline constexpr std::size_t outputs = 2 * pairs;  // x and y for each pair of numbers

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&lens_point) function, std::span<const double> in, std::span<double> out) {
    std::size_t place = 0;
    for (const auto& [u, v] : number_pairs(in[1])) {
        const auto [x, y] = function(in[0], u, v);
        out[place++] = x;
        out[place++] = y;
    }
}

}  // namespace raylab::grading::lens
