#pragma once

#include "raylab/scene/scene.h"

namespace raylab {

/// The scene as the tracer behind the counts published for the Standard Procedural Databases saw it (V. Havran, 1999):
/// cones and cylinders from their outer side only, everything else from both. (Chapter 06 tells how that was found.)
Scene with_spd_sides(Scene scene);

}  // namespace raylab
