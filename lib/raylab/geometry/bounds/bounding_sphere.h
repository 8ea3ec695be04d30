#pragma once

#include "raylab/geometry/bounds/hull.h"

namespace raylab {

/// A sphere around balls, its radius rounded up; nearly the smallest. (Badoiu and Clarkson, Smaller core-sets for
/// balls, SODA 2003: again and again the center takes a step, each time a shorter one, toward what lies farthest from
/// it; mostly among a few extremes.) Its radius is infinite where something reaches to infinity, and minus infinity
/// around nothing.
Sphere bounding_sphere(std::span<const Ball> balls);

}  // namespace raylab
