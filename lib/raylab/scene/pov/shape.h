#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <string>

namespace raylab::pov {

/// A shape at its place, its brace left open for what follows: "sphere { <0, 1, 0>, 1". `mesh_name` is what the mesh,
/// if it is one, was declared as.
std::string placed_shape(const Shape& shape, const Affine& placement, const std::string& mesh_name);

/// How a mesh's shadow is found: it is opaque, or as its textures are at the hit (slower).
enum class MeshShadow { opaque, by_texture };

/// A mesh2, closed.
std::string mesh(const Mesh& mesh, MeshShadow shadow);

}  // namespace raylab::pov
