#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

// CGAL's own test of a ray and a triangle, in two of its kernels: a second opinion on the oracle, and the trap it
// avoids.

namespace raylab::oracle {

/// CGAL's predicate on exact constructions: right for every ray from t = 0 on, but a coplanar ray that overlaps counts.
bool epeck_hits(const RayOf<double>& ray, const TriangleOf<double>& triangle);

/// The same predicate, exact too, but on inexact constructions: CGAL keeps a ray as two points, and origin + direction
/// is rounded. So it answers exactly about another ray.
bool epick_hits(const RayOf<double>& ray, const TriangleOf<double>& triangle);

}  // namespace raylab::oracle
