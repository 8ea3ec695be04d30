#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace raylab {

/// Reads a scene file: TOML (.toml, described by scene.schema.json) or Haines' Neutral File Format (.nff). It throws an
/// Error, with file and line, for whatever is not a scene, and before it allocates more memory than the limit.
Scene read_scene(const std::filesystem::path& path, const MemoryLimit& limit = {});

/// Reads a scene from text. `path` names it in errors, its extension chooses the format, and files that it mentions are
/// looked for beside it.
Scene read_scene_text(std::string_view text, const std::filesystem::path& path, const MemoryLimit& limit = {});

/// The JSON Schema of TOML scene files, which is the content of scene.schema.json.
std::string scene_schema();

}  // namespace raylab
