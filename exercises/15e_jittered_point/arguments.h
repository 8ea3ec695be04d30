#pragma once

#include "number_pairs.h"

#include "raylab/sampling/pattern/jittered_point.h"

#include <span>

namespace raylab::grading::jitter {

inline constexpr std::size_t most_cells = 64;
inline constexpr std::size_t inputs = 2;  // how many cells, and which numbers

// A point for each pair of numbers; then of each cell that there is the points of the numbers 0, 0 and of the largest
// ones.
inline constexpr std::size_t outputs = 2 * pairs + 4 * most_cells;

inline std::size_t count_of(std::span<const double> in) { return static_cast<std::size_t>(in[0]); }

/// The cell that a pair of numbers is asked for: any number of steps from one to the next that spreads them over all.
inline std::size_t cell_of_pair(std::size_t i, std::size_t count) { return i * 7919 / 4 % count; }

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&jittered_point) function, std::span<const double> in, std::span<double> out) {
    const std::size_t count = count_of(in);
    std::size_t place = 0;
    const auto ask = [&](std::size_t cell, double u, double v) {
        for (const double x : function(static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(count), u, v))
            out[place++] = x;
    };
    const auto numbers = number_pairs(in[1]);
    for (std::size_t i = 0; i < pairs; ++i) ask(cell_of_pair(i, count), numbers[i].u, numbers[i].v);
    for (std::size_t cell = 0; cell < count; ++cell) {
        ask(cell, 0, 0);
        ask(cell, 1 - 0x1p-53, 1 - 0x1p-53);
    }
    while (place < outputs) out[place++] = 0;
}

}  // namespace raylab::grading::jitter
