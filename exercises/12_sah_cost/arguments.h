#pragma once

#include "raylab/accelerator/sah_cost.h"

#include <span>

namespace raylab::grading::cuts {

inline constexpr std::size_t inputs = 10;  // SahCut's numbers, as it has them
inline constexpr std::size_t outputs = 1;  // the cost

inline SahCut arguments(std::span<const double> in) {
    return {{in[0], in[1], in[2]}, static_cast<int>(in[3]), in[4], in[5], in[6], in[7], in[8], in[9]};
}

/// One case through one function of the slot's type.
inline void answer(decltype(&sah_cost) function, std::span<const double> in, std::span<double> out) {
    out[0] = function(arguments(in));
}

}  // namespace raylab::grading::cuts
