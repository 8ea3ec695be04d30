#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"
#include "raylab/report/stability.h"

#include <string>

// A single ray and a single shape as the example of a stability case, in words and drawn. A drawing is for the eye: it
// ignores rounding, and no decision depends on it.

namespace raylab {

/// In the plane of the ray and the sphere's centre.
CaseExample example_of(const Ray& ray, const Sphere& sphere, TrueAnswer truth);

/// Seen along the ray, which is a point.
CaseExample example_of(const Ray& ray, const Triangle& triangle, TrueAnswer truth);

}  // namespace raylab
