#pragma once

#include "raylab/report/plane/plane_drawing.h"

#include <vector>

namespace raylab {

/// The convex hull of points, counter-clockwise (Andrew's monotone chain, 1979).
std::vector<PlanePoint> convex_hull(std::vector<PlanePoint> points);

}  // namespace raylab
