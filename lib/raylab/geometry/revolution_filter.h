#pragma once

#include "raylab/geometry/shapes.h"
#include "raylab/geometry/verdict.h"

// What plain doubles say of a ray and a cylinder or cone at rest. Most rays that come near miss it, and most of these leave it or
// go round it; most that hit enter it from outside, clearly. All others are left to meet_revolution.h, whose t this one is.

namespace raylab::revolution_filter {

FilterVerdict decide(const Ray& ray, const Cylinder& cylinder, Sides sides);
FilterVerdict decide(const Ray& ray, const Cone& cone, Sides sides);

}  // namespace raylab::revolution_filter
