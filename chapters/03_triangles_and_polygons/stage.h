#pragma once

#include "raylab/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace raylab {

/// The chapter's scene with a mesh in it: the elephant where it has been fetched, otherwise a generated knot.
struct Stage {
    Scene scene;
    std::string mesh;  // "elephant" or "knot"
    std::size_t triangles;
};

Stage set_stage(const std::filesystem::path& scene_file);

}  // namespace raylab
