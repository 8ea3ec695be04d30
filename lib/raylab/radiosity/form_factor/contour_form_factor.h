#pragma once

#include "raylab/geometry/vector.h"

#include <span>

namespace raylab {

/// The form factor from a small patch at a point to a polygon: the share of what the patch sends out that arrives at
/// the polygon, if nothing stands between. It is Lambert's contour integral (J. H. Lambert, Photometria, 1760), a sum
/// over the edges; Baum, Rushmeier and Winget (SIGGRAPH 89) brought it to radiosity.
///
/// The normal has length 1. The polygon is planar and convex, and its vertices go counter-clockwise as seen from the
/// side that receives. What lies below the point's horizon does not count. A point in the polygon's plane or behind it
/// sends nothing there. Weak spot: the terms of a polygon seen under a small angle w cancel, and leave a relative error
/// of 1e-16/w. This is the slot of exercise 14.
double contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon);

}  // namespace raylab
