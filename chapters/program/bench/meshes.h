#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab::bench {

/// A scene of one mesh: "bunny" and the other scanned meshes where they have been fetched, "bumpy_5" (a bumpy sphere,
/// five levels), "knot_8", "torus_9", or a mesh file. An Error lists the known names.
Scene scene_of_mesh(const std::string& name);

/// Throws an Error where scene_of_mesh() knows no such mesh or finds no such file, without generating a mesh.
void refuse_unknown_mesh(const std::string& name);

/// The scanned meshes that have been fetched, and generated ones of up to a million triangles.
std::vector<std::string> usual_meshes();

/// The scene's mesh.
const Mesh& mesh_of(const Scene& scene);

}  // namespace raylab::bench
