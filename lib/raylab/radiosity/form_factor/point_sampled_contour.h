#pragma once

#include "raylab/radiosity/form_factor/polygon_points.h"

namespace raylab {

/// The form factor from a patch to a polygon in full view: the mean of contour_form_factor() over points of the patch,
/// by their areas. The points and the patch's normal, of length 1, are made once for all polygons that the patch sees.
/// Weak spot: a polygon nearer than the distance between two points; where both share an edge the error falls no faster
/// than with the inverse of the number of points.
double point_sampled_contour(std::span<const PolygonPoint> points, const Vec3d& normal, std::span<const Vec3d> to);

/// The same with per_side^2 Gauss points.
double point_sampled_contour(std::span<const Vec3d> from, std::span<const Vec3d> to, int per_side);

}  // namespace raylab
