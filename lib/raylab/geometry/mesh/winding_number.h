#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

namespace raylab {

/// The winding number of a transformed mesh about a point: 1 inside a closed mesh whose triangles face outward, 0
/// outside, something between where the mesh has holes. The solid angle of all triangles over 4 pi, each by van
/// Oosterom and Strackee (The Solid Angle of a Plane Triangle, IEEE Trans. Biomedical Engineering 30(2), 1983); the
/// name and its use for meshes with holes are Jacobson's (Robust Inside-Outside Segmentation, SIGGRAPH 2013).
double winding_number(const Vec3d& point, const Mesh& mesh, const Affine& placement);

}  // namespace raylab
