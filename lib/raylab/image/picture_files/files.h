#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/base/output_file.h"
#include "raylab/image/image.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

// PNG is read and written by libpng, EXR by OpenImageIO, which is loaded when it is first needed (openimageio.h).

namespace raylab {

/// Reads EXR (float, linear) or PNG (8 or 16 bits, decoded from sRGB to linear). It throws an Error for an unreadable
/// file, for another format, for more than 2^28 pixels and, before allocating, for more memory than the limit. Values
/// that are not finite are returned as they are in the file. Of an EXR with more channels only R, G and B (or Y) are
/// read.
Image read_image(const std::filesystem::path& path, const MemoryLimit& limit = {});

/// The bytes of a PNG file: 8 bits, sRGB, values clamped to [0, 1]. It expects finite values and at least one pixel.
std::string png_bytes(const Image& image);

/// The same of colours that are bytes already: red, green and blue of each pixel, row after row.
std::string png_bytes(int width, int height, std::span<const std::uint8_t> colors);

/// Writes a picture in the format of the extension: .exr (float, linear) or .png (8 bits, sRGB, values clamped to [0,
/// 1]), whole or not at all. It throws an Error that names the pixel where one is NaN or infinite, and then writes
/// nothing.
void write_image(const Image& image, const OutputFile& file);

}  // namespace raylab
