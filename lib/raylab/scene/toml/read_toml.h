#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/scene.h"

#include <filesystem>
#include <string_view>

namespace raylab::toml_file {

/// A scene from TOML text, with the scenes that it includes and the meshes that it names; all together stay within the
/// memory limit.
Scene read(std::string_view text, const std::filesystem::path& path, const MemoryLimit& limit = {});

}  // namespace raylab::toml_file
