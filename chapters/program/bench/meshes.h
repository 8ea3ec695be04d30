#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab::bench {

/// A scene of one mesh: "bunny" and the other scanned meshes where they have been fetched, "bumpy_5" (a bumpy sphere,
/// five levels), "hall_4", "city_3" and others made by rule, or a mesh file. Its camera sees the mesh, and its light is
/// where shadow rays go. An Error lists the known names.
Scene scene_of_mesh(const std::string& name);

/// Throws an Error where scene_of_mesh() knows no such mesh or finds no such file, without generating a mesh.
void refuse_unknown_mesh(const std::string& name);

/// The scanned meshes that have been fetched, and generated ones of up to a million triangles.
std::vector<std::string> usual_meshes();

/// The families of generated meshes with their levels in one line: "bumpy_0 to bumpy_8, ...".
std::string mesh_families();

/// What kind of mesh the name stands for: "scans", "architecture" or "generated"; "files" for a file. Kinds are
/// averaged each for itself, because structures differ on them.
std::string kind_of_mesh(const std::string& name);

/// The scene's mesh.
const Mesh& mesh_of(const Scene& scene);

}  // namespace raylab::bench
