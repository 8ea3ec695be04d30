#include "raylab/scene/read_scene.h"

#include "fuzz/value_or_error.h"

// Any bytes must give a scene or an Error. Files that the text mentions are looked for beside the scenes from which
// fuzzing starts.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::filesystem::path path = RAYLAB_SOURCE "/tests/scene/files/fuzz.toml";
    return value_or_error(data, size, [](std::string_view text) { raylab::read_scene_text(text, path); });
}
