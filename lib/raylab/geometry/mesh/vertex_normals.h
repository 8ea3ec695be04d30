#pragma once

#include "raylab/geometry/shapes.h"

namespace raylab {

/// Unit normals for a mesh's vertices: the mean of the normals of the triangles around each, weighted by the angle a
/// triangle has there, so that it does not matter how a face is cut into triangles. (G. Thuermer, C. Wuethrich:
/// Computing Vertex Normals from Polygonal Facets, JGT 3(1), 1998.) Zero where there are none, and where they cancel.
std::vector<Vec3f> vertex_normals(const Mesh& mesh);

/// The mesh with these normals in place of what it has.
Mesh with_vertex_normals(Mesh mesh);

}  // namespace raylab
