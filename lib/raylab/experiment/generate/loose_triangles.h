#pragma once

#include "raylab/geometry/shapes.h"

#include <memory>
#include <vector>

// Meshes of triangles that share no corner.

namespace raylab {

/// Adds one triangle, with corners of its own.
void add(Mesh& mesh, const Triangle& triangle);

/// Adds the parallelogram from a corner along u and along v, as two triangles with four corners of their own.
void add_parallelogram(Mesh& mesh, const Vec3f& corner, const Vec3f& u, const Vec3f& v);

/// The triangles in their order.
std::shared_ptr<const Mesh> mesh_of(const std::vector<Triangle>& triangles);

}  // namespace raylab
