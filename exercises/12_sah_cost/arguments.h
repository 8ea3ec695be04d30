#pragma once

#include "raylab/accelerator/split_tree/sah_cost.h"

#include <span>
#include <vector>

namespace raylab::grading::cuts {

inline constexpr std::size_t inputs = 10;  // the members of SahCut, in their order
inline constexpr std::size_t outputs = 1;  // the cost

inline SahCut arguments(std::span<const double> in) {
    return {{in[0], in[1], in[2]}, static_cast<int>(in[3]), in[4], in[5], in[6], in[7], in[8], in[9]};
}

inline std::vector<double> as_input(const SahCut& cut) {
    return {cut.size.x,    cut.size.y,     cut.size.z, static_cast<double>(cut.axis),
            cut.place,     cut.below,      cut.above,  cut.visit_cost,
            cut.test_cost, cut.empty_bonus};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&sah_cost) function, std::span<const double> in, std::span<double> out) {
    out[0] = function(arguments(in));
}

}  // namespace raylab::grading::cuts
