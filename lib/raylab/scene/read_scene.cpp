#include "raylab/scene/read_scene.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/nff/read_nff.h"
#include "raylab/scene/toml/read_toml.h"
#include "raylab/scene/toml/scene_format.h"

namespace raylab {

namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 28;  // for each file; SPD's largest scenes have some 40 MB

}  // namespace

Scene read_scene(const std::filesystem::path& path, const MemoryLimit& limit) {
    return read_scene_text(read_file(path, max_bytes), path, limit);
}

Scene read_scene_text(std::string_view text, const std::filesystem::path& path, const MemoryLimit& limit) {
    if (path.extension() == ".toml") return toml_file::read(text, path, limit);
    if (path.extension() == ".nff") return read_nff(text, path.string());
    throw Error({path.string()}, "a scene file (.toml or .nff)", "the extension \"" + path.extension().string() + '"');
}

std::string scene_schema() { return toml_file::json_schema(toml_file::scene_format(), "A scene of raylab"); }

}  // namespace raylab
