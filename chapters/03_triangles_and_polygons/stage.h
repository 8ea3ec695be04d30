#pragma once

#include "raylab/scene/scene.h"

#include <filesystem>

namespace raylab {

/// The chapter's scene with a mesh in it: the elephant where it has been fetched, otherwise a generated knot.
Scene scene_with_mesh(const std::filesystem::path& scene_file);

}  // namespace raylab
