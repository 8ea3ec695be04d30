#pragma once

#include "raylab/scene/scene.h"

namespace raylab {

/// Gives the scene the visible sides that it had for the tracer behind the published counts of the Standard Procedural
/// Databases (V. Havran, 1999): cones and cylinders are seen from their outer side only, everything else from both.
/// (Chapter 06 tells how that was found.)
Scene with_spd_sides(Scene scene);

}  // namespace raylab
