#include "raylab/base/error.h"
#include "raylab/scene/read_scene.h"

#include <cstddef>
#include <cstdint>

// Any bytes are a scene or an Error. Files that the text mentions are looked for where none are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        raylab::read_scene_text({reinterpret_cast<const char*>(data), size}, "/nowhere/fuzz.toml");
    } catch (const raylab::Error&) {
    }
    return 0;
}
