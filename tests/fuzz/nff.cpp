#include "raylab/scene/read_scene.h"

#include "fuzz/value_or_error.h"

// Any bytes must give a scene or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return value_or_error(data, size,
                          [](std::string_view text) { raylab::read_scene_text(text, "/nowhere/fuzz.nff"); });
}
