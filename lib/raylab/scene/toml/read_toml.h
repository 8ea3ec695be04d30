#pragma once

#include "raylab/scene/scene.h"

#include <filesystem>
#include <string_view>

namespace raylab::toml_file {

/// A scene from TOML text, with the scenes it includes and the meshes it names.
Scene read(std::string_view text, const std::filesystem::path& path);

}  // namespace raylab::toml_file
