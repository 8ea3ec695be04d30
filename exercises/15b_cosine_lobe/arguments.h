#pragma once

#include "number_pairs.h"

#include "raylab/sampling/mapping/cosine_direction.h"

#include <span>

namespace raylab::grading::cosine_lobe {

inline constexpr std::size_t inputs = 1;           // which numbers
inline constexpr std::size_t outputs = 4 * pairs;  // the direction and its density for each pair of numbers

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&cosine_direction) function, std::span<const double> in, std::span<double> out) {
    std::size_t place = 0;
    for (const auto& [u, v] : number_pairs(in[0])) {
        const auto [direction, pdf] = function(u, v);
        for (const double value : {direction.x, direction.y, direction.z, pdf}) out[place++] = value;
    }
}

/// The answer to one of the pairs.
inline SampledDirection sampled(std::span<const double> out, std::size_t i) {
    return {{out[4 * i], out[4 * i + 1], out[4 * i + 2]}, out[4 * i + 3]};
}

}  // namespace raylab::grading::cosine_lobe
