#pragma once

#include "raylab/geometry/shapes.h"

#include <string>

namespace raylab::pov {

/// A shape in its own coordinates, its brace left open for what follows: "sphere { <0, 1, 0>, 1". `mesh_name` is what
/// the mesh, if it is one, was declared as.
std::string shape(const Shape& shape, const std::string& mesh_name);

/// A mesh2, closed.
std::string mesh(const Mesh& mesh);

}  // namespace raylab::pov
