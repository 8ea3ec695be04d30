#include "raylab/base/error.h"
#include "raylab/scene/read_scene.h"

#include <cstddef>
#include <cstdint>

// Any bytes are a scene or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        raylab::read_scene_text({reinterpret_cast<const char*>(data), size}, "/nowhere/fuzz.nff");
    } catch (const raylab::Error&) {
    }
    return 0;
}
