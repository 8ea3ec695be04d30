#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab::bench {

/// A scene of one mesh: "bunny" and the other real ones where they are fetched, "bumpy_5" (a bumpy sphere, five
/// levels), "knot_8", "torus_9", or a mesh file. Error says what is known.
Scene scene_of_mesh(const std::string& name);

/// Error where scene_of_mesh() knows no such mesh or finds no such file; nothing is made.
void refuse_unknown_mesh(const std::string& name);

/// The real meshes that are here, and generated ones up to a million triangles.
std::vector<std::string> usual_meshes();

/// The scene's mesh.
const Mesh& mesh_of(const Scene& scene);

}  // namespace raylab::bench
