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

/// The answer of CGAL::do_intersect to Ray_3(origin, direction) in this kernel; the ray's range is ignored. The exact
/// kernel is right for every ray from t = 0 on, but counts a coplanar ray that overlaps the triangle.
bool cgal_do_intersect(CgalKernel kernel, const RayOf<double>& ray, const TriangleOf<double>& triangle);

}  // namespace raylab::oracle
