#pragma once

#include "raylab/base/memory_limit.h"

#include <cstdint>
#include <string>

namespace raylab {

/// What a picture file's header says, before its pixels are read.
struct PictureClaim {
    std::int64_t width, height;
    std::uint64_t file_bytes;
    double buffers;    // bytes that reading takes in addition to the Image
    std::string what;  // "256 channels"
};

/// Throws an Error, naming `file`, for a picture without pixels, for more than 2^28 pixels or than the file's bytes can
/// hold, and where reading needs more memory than the limit.
void check_picture_size(const PictureClaim& claim, const std::string& file, const MemoryLimit& limit);

}  // namespace raylab
