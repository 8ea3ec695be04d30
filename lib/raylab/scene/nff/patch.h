#pragma once

#include "raylab/geometry/shapes.h"

#include <vector>

namespace raylab {

/// Makes a polygonal patch: a Mesh with normals where the fan from its first vertex covers it once, otherwise a Polygon
/// without normals.
Shape make_patch(std::vector<Vec3f> vertices, std::vector<Vec3f> normals);

}  // namespace raylab
