#pragma once

#include <cstdint>
#include <filesystem>

namespace raylab {

/// The header of an EXR file's first part, the one that is read. It is checked before OpenEXR relies on it.
struct ExrHeader {
    std::int64_t width = 0, height = 0;  // of the data window
    std::int64_t channels = 0;
    std::int64_t pixel_bytes = 0;                  // of all channels
    std::int64_t chunk_lines = 1;                  // the number compressed together where there are no tiles
    std::int64_t tile_width = 0, tile_height = 0;  // 0: no tiles
};

/// Reads the headers of all parts. It throws an Error, naming the file and the byte, for an attribute that is longer
/// than the rest of the file, for more attributes, channels or chunks than any file of that size has, and for deep
/// pictures.
ExrHeader read_exr_header(const std::filesystem::path& path);

}  // namespace raylab
