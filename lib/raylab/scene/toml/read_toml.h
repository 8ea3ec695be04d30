#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/scene.h"

#include <filesystem>
#include <string_view>

namespace raylab::toml_file {

/// A scene from TOML text, with the scenes it includes and the meshes it names; all together within the limit.
Scene read(std::string_view text, const std::filesystem::path& path, const MemoryLimit& limit = {});

}  // namespace raylab::toml_file
