#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <vector>

namespace raylab {

/// The colour channels, those with the same reflectance of every patch together: one factorised matrix serves them all.
std::vector<std::vector<int>> channel_groups(const RadiositySystem& system);

}  // namespace raylab
