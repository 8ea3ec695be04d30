#include "raylab/scene/demo_meshes.h"

#include <algorithm>
#include <cassert>

namespace raylab {

std::vector<std::string> demo_mesh_names() { return {"elephant", "elephant_coarse", "bunny", "armadillo", "dragon"}; }

std::optional<std::filesystem::path> demo_mesh(const std::string& name) {
    const auto names = demo_mesh_names();
    assert(std::ranges::find(names, name) != names.end());
    const auto file = std::filesystem::path(RAYLAB_MESHES) / (name + ".off");
    std::error_code unreadable;
    if (!std::filesystem::is_regular_file(file, unreadable)) return std::nullopt;
    return file;
}

}  // namespace raylab
