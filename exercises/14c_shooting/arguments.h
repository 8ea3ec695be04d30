#pragma once

#include "patch_system.h"

#include "raylab/radiosity/solve/shooting_step.h"

#include <algorithm>
#include <span>

namespace raylab::grading::shooting {

inline constexpr std::size_t inputs = system_doubles + 2 * color_doubles;  // the system, radiosities, unshot ones
inline constexpr std::size_t outputs = 1 + 2 * color_doubles;              // the shooter, radiosities, unshot ones

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&shooting_step) function, std::span<const double> in, std::span<double> out) {
    const RadiositySystem system = system_of(taken(in, system_doubles));
    Radiosities radiosity = colors_of(taken(in, color_doubles), system.patches());
    Radiosities unshot = colors_of(in, system.patches());
    std::ranges::fill(out, 0.0);  // of patches that are not there
    out[0] = static_cast<double>(function(system, radiosity, unshot));
    put_colors(radiosity, out.subspan(1));
    put_colors(unshot, out.subspan(1 + color_doubles));
}

}  // namespace raylab::grading::shooting
