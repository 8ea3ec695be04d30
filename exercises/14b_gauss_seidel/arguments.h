#pragma once

#include "patch_system.h"

#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include <algorithm>
#include <span>

namespace raylab::grading::gauss_seidel {

inline constexpr std::size_t inputs = system_doubles + color_doubles;  // the system, and the radiosities before
inline constexpr std::size_t outputs = color_doubles;                  // the radiosities after the sweep

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&gauss_seidel_sweep) function, std::span<const double> in, std::span<double> out) {
    const RadiositySystem system = system_of(taken(in, system_doubles));
    Radiosities radiosity = colors_of(in, system.patches());
    function(system, radiosity);
    std::ranges::fill(out, 0.0);  // of patches that are not there
    put_colors(radiosity, out);
}

}  // namespace raylab::grading::gauss_seidel
