#pragma once

#include "raylab/geometry/vector.h"

#include <span>

namespace raylab {

/// Area times form factor of two convex polygons in full view, each in front of the other's plane, as the double
/// contour integral 1/(2 pi) sum over pairs of edges of the integral of ln r dr1.dr2, in closed form; pairs of edges
/// that are nearly parallel, where that loses digits, are integrated numerically. Polygons which share an edge, a
/// vertex, or a part of either, are no special case. Weak spot: of small distant polygons the terms cancel, and leave a
/// relative error of about 1e-16 times the square of distance by size.
double double_contour(std::span<const Vec3d> from, std::span<const Vec3d> to);

}  // namespace raylab
