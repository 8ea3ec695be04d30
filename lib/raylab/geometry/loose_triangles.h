#pragma once

#include "raylab/geometry/shapes.h"

#include <memory>
#include <vector>

// Meshes of triangles that share no corner.

namespace raylab {

/// One triangle more, with corners of its own.
void add(Mesh& mesh, const Triangle& triangle);

/// From a corner along u and along v, as two triangles more with four corners of their own.
void add_parallelogram(Mesh& mesh, const Vec3f& corner, const Vec3f& u, const Vec3f& v);

/// The triangles in their order.
std::shared_ptr<const Mesh> mesh_of(const std::vector<Triangle>& triangles);

}  // namespace raylab
