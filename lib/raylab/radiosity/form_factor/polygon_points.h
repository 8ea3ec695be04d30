#pragma once

#include "raylab/geometry/vector.h"

#include <span>
#include <vector>

namespace raylab {

/// A point of a polygon, and the area for which it stands.
struct PolygonPoint {
    Vec3d position;
    double area;  // m^2
};

/// Gauss points of a convex polygon: per_side^2 in each quadrangle of a fan, the last of which may be a triangle. Their
/// areas sum to the polygon's. A triangle or a quadrangle is one part.
std::vector<PolygonPoint> gauss_points(std::span<const Vec3d> polygon, int per_side);

}  // namespace raylab
