#pragma once

#include "raylab/geometry/filter/carried_ray.h"
#include "raylab/geometry/predicate/verdict.h"
#include "raylab/geometry/shapes.h"

// The filter in plain doubles for a ray and a cylinder or cone. Most rays that come near miss
// it, and most of these leave it or pass beside it; most that hit enter it from outside, or leave it from within or
// through an opening, clearly. All others are left to revolution_intersection.h. The t of a hit has the same bits as
// there, if the shape is at rest.

namespace raylab::revolution_filter {

FilterVerdict decide(const Ray& ray, const Cylinder& cylinder, Sides sides);
FilterVerdict decide(const Ray& ray, const Cone& cone, Sides sides);

// The same of a shape where it stands at the ray's time, if it only translates.
FilterVerdict decide(const Ray& ray, const Cylinder& cylinder, const Affine& placement, const Motion& motion,
                     Sides sides);
FilterVerdict decide(const Ray& ray, const Cone& cone, const Affine& placement, const Motion& motion, Sides sides);

// The same of a shape that is placed: the ray, as seen from its base.
FilterVerdict decide(const CarriedRay& ray, const Cylinder& cylinder, Sides sides);
FilterVerdict decide(const CarriedRay& ray, const Cone& cone, Sides sides);

}  // namespace raylab::revolution_filter
