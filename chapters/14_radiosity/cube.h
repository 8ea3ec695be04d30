#pragma once

#include "raylab/radiosity/radiosity_system.h"

namespace raylab::cornell {

/// A unit cube from inside, a patch a face, whose ceiling (patch 0, opposite to 1) emits 1. A row of its form factors
/// sums to `row`, which should be 1.
RadiositySystem cube(double reflectance, double row = 1);

}  // namespace raylab::cornell
