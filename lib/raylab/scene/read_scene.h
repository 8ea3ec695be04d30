#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace raylab {

/// Reads a scene file: TOML (.toml, scene.schema.json describes it) or Haines' Neutral File Format (.nff).
/// Error, with file and line, for whatever is not a scene and, before it is taken, for more memory than the limit.
Scene read_scene(const std::filesystem::path& path, const MemoryLimit& limit = {});

/// The same from text; `path` names it in errors, its extension chooses the format, and the files that it mentions are
/// looked for beside it.
Scene read_scene_text(std::string_view text, const std::filesystem::path& path, const MemoryLimit& limit = {});

/// The JSON Schema of TOML scene files: what scene.schema.json holds.
std::string scene_schema();

}  // namespace raylab
