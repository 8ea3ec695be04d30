#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

// A trap to be shown, not a method to be used: CGAL's Ray_3(point, vector) keeps the ray's origin and *a second point*,
// point + vector. The quick kernel (EPICK) rounds that sum, so that its ray is not the one that was asked for.

namespace raylab::oracle {

enum class CgalKernel {
    epick,  // exact predicates, inexact constructions
    epeck,  // exact predicates and constructions
};

/// What CGAL::do_intersect says of Ray_3(origin, direction) in this kernel. The ray's range is not asked about.
bool cgal_do_intersect(CgalKernel kernel, const RayOf<double>& ray, const TriangleOf<double>& triangle);

}  // namespace raylab::oracle
