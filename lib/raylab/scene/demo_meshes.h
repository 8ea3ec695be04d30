#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// The real meshes of the tour: "elephant", "bunny", "armadillo", "dragon", and "elephant_coarse" for quick looks. They
/// come with Debian's package libcgal-demo; cmake/fetch_meshes.sh fetches them.
std::vector<std::string> demo_mesh_names();

/// Where the mesh is; absent: it has not been fetched. Another name is a broken promise (assertion).
std::optional<std::filesystem::path> demo_mesh(const std::string& name);

}  // namespace raylab
