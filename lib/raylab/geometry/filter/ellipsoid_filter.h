#pragma once

#include "raylab/geometry/filter/carried_ray.h"
#include "raylab/geometry/filter/sphere_filter.h"

// The filter in plain doubles for a ray and an ellipsoid, or a sphere that is placed. The t of a hit has the same bits
// as by quadric_intersection.h, if the shape is at rest where it was made.

namespace raylab::ellipsoid_filter {

using sphere_filter::SphereVerdict;

SphereVerdict decide(const Ray& ray, const Ellipsoid& ellipsoid, Sides sides);

// The same of an ellipsoid where it stands at the ray's time, if it only translates.
SphereVerdict decide(const Ray& ray, const Ellipsoid& ellipsoid, const Affine& placement, const Motion& motion,
                     Sides sides);

// The same of a shape that is placed: the ray, as seen from its center.
SphereVerdict decide(const CarriedRay& ray, const Ellipsoid& ellipsoid, Sides sides);
SphereVerdict decide(const CarriedRay& ray, const Sphere& sphere, Sides sides);

}  // namespace raylab::ellipsoid_filter
