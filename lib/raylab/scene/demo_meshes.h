#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// The names of the tour's scanned meshes: "elephant", "bunny", "armadillo", "dragon", and "elephant_coarse" for quick
/// looks. They are part of Debian's package libcgal-demo; cmake/fetch_meshes.sh fetches them.
std::vector<std::string> demo_mesh_names();

/// The path of the mesh; absent if it has not been fetched. The name must be one of demo_mesh_names() (an assertion).
std::optional<std::filesystem::path> demo_mesh(const std::string& name);

}  // namespace raylab
