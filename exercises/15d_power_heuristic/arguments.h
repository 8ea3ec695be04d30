#pragma once

#include "raylab/transport/power_heuristic.h"

#include <span>

namespace raylab::grading::heuristic {

inline constexpr std::size_t inputs = 2;   // the density of the strategy that chose, and that of the other
inline constexpr std::size_t outputs = 1;  // the weight

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&power_heuristic) function, std::span<const double> in, std::span<double> out) {
    out[0] = function(in[0], in[1]);
}

}  // namespace raylab::grading::heuristic
