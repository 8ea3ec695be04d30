#pragma once

#include "raylab/geometry/predicate/verdict.h"
#include "raylab/geometry/shapes.h"

// The filter in plain doubles for a ray and a cylinder or cone that is not transformed. Most rays that come near miss
// it, and most of these leave it or pass beside it; most that hit enter it from outside, clearly. All others are left
// to revolution_intersection.h, and the t of a hit has the same bits as there.

namespace raylab::revolution_filter {

FilterVerdict decide(const Ray& ray, const Cylinder& cylinder, Sides sides);
FilterVerdict decide(const Ray& ray, const Cone& cone, Sides sides);

}  // namespace raylab::revolution_filter
