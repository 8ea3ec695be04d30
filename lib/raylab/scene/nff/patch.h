#pragma once

#include "raylab/geometry/shapes.h"

#include <vector>

namespace raylab {

/// Polygonal patch: a Mesh with normals where fanning from its first vertex covers it once, else the bare Polygon.
Shape make_patch(std::vector<Vec3f> vertices, std::vector<Vec3f> normals);

}  // namespace raylab
