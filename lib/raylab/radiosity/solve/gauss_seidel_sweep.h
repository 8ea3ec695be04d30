#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <span>

namespace raylab {

/// One Gauss-Seidel sweep, which is gathering: patch after patch, from the first to the last, the radiosity equation of
/// that patch is solved for its own radiosity, with the newest radiosities of all others. `radiosity` holds one value a
/// patch and is updated in place. A concave patch sees itself, F_ii > 0, and then stands on both sides of its equation.
/// This is the slot of exercise 14b.
void gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity);

}  // namespace raylab
