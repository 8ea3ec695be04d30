#pragma once

#include "raylab/tracer/followed_branches.h"

#include <span>
#include <vector>

namespace raylab::grading::branches {

inline constexpr std::size_t inputs = 7;
inline constexpr std::size_t outputs = 2;  // the weights of both branches

using Arguments = BranchingHit;

inline Arguments arguments(std::span<const double> in) {
    return {in[0], in[1], in[2], static_cast<int>(in[3]), in[4], in[5], in[6]};
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [weight, reflected, transmitted, levels, brightest, largest_share, least] = given;
    return {weight, reflected, transmitted, static_cast<double>(levels), brightest, largest_share, least};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&followed_branches) function, std::span<const double> in, std::span<double> out) {
    const auto [reflected, transmitted] = function(arguments(in));
    out[0] = reflected;
    out[1] = transmitted;
}

}  // namespace raylab::grading::branches
