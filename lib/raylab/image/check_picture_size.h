#pragma once

#include "raylab/base/memory_limit.h"

#include <cstdint>
#include <string>

namespace raylab {

/// What a picture file says of itself, before its pixels are read.
struct PictureClaim {
    std::int64_t width, height;
    std::uint64_t file_bytes;
    double buffers;    // bytes that reading takes beside the Image
    std::string what;  // "256 channels"
};

/// Error, naming `file`, where there is no pixel, where there are more than 2^28 or than so many bytes can hold, and
/// where reading needs more memory than the limit.
void check_picture_size(const PictureClaim& claim, const std::string& file, const MemoryLimit& limit);

}  // namespace raylab
