#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <cstddef>
#include <span>

namespace raylab {

/// One step of progressive refinement (Cohen, Chen, Wallace and Greenberg, SIGGRAPH 88). The patch with the most unshot
/// power, which is its area times the sum of its unshot colour channels, sends all of it out; of equal patches it is
/// the first. What each patch j receives and reflects is added to its radiosity and to what it has not shot yet. The
/// step reads row i of the form factors alone: A_i F_ij = A_j F_ji gives the column. Both spans hold one value a patch,
/// of at least one, and are updated in place. The result is the patch that shot. This is the slot of exercise 14c.
std::size_t shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot);

}  // namespace raylab
