#pragma once

#include "raylab/tracer/shading/fresnel.h"

#include <span>

namespace raylab::grading::fresnel_share {

inline constexpr std::size_t inputs = 3;   // the cosine before the surface, the two indices of refraction
inline constexpr std::size_t outputs = 1;  // the share that is reflected

struct Arguments {
    double cosine, ior_before, ior_behind;
};

inline Arguments arguments(std::span<const double> in) { return {in[0], in[1], in[2]}; }

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&fresnel) function, std::span<const double> in, std::span<double> out) {
    out[0] = function(in[0], in[1], in[2]);
}

}  // namespace raylab::grading::fresnel_share
