#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <span>

namespace raylab {

/// Shooting's radiosities for display, before it has ended: what has not been shot yet is taken to be spread over all
/// patches by their areas, and to be reflected by the mean reflectance without end. Cohen, Chen, Wallace and Greenberg,
/// SIGGRAPH 88. The solution itself does not use it.
Radiosities with_ambient_estimate(const RadiositySystem& system, std::span<const Color> radiosity,
                                  std::span<const Color> unshot);

}  // namespace raylab
