#include "raylab/accelerator/ray_file.h"

#include "fuzz/value_or_error.h"

#include <cassert>

// Any bytes must give rays that are written as they were read, or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return value_or_error(data, size, [](std::string_view bytes) {
        const auto rays = raylab::rays_from_bytes(bytes, "fuzz");
        assert(raylab::to_bytes(rays) == bytes);
    });
}
