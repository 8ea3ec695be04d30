#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <string>

namespace raylab::pov {

/// A shape at its place, with its brace left open for what follows: "sphere { <0, 1, 0>, 1". `mesh_name` is the name
/// under which a mesh was declared.
std::string placed_shape(const Shape& shape, const Affine& placement, const std::string& mesh_name);

/// How the shadow of a mesh is determined: it is opaque, or its textures decide at each hit, which is slower.
enum class MeshShadow { opaque, by_texture };

/// A mesh2, with its brace closed.
std::string mesh(const Mesh& mesh, MeshShadow shadow);

}  // namespace raylab::pov
