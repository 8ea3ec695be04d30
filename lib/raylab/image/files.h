#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/base/output_file.h"
#include "raylab/image/image.h"

#include <filesystem>
#include <string>

// PNG is read and written by libpng, EXR by OpenImageIO, which is loaded when it is first wanted (openimageio.h).

namespace raylab {

/// EXR (float, linear) or PNG (8 or 16 bit, decoded from sRGB to linear). Error for anything unreadable, for another
/// format, for sizes past 2^28 pixels and, before it is taken, for more memory than the limit. Non-finite values are
/// returned as they stand in the file. Of an EXR with more channels only R, G and B (or Y) are read.
Image read_image(const std::filesystem::path& path, const MemoryLimit& limit = {});

/// By extension: .exr (float, linear) or .png (8 bit, sRGB, values clamped to [0, 1]). Error where a pixel is NaN or
/// infinite: it is named, and nothing is written. Whole or not at all.
void write_image(const Image& image, const OutputFile& file);

/// folder/name.png to look at and folder/name.exr to compare with; returns the former's name, "name.png".
std::string write_picture(const Image& image, const std::filesystem::path& folder, const std::string& name);

}  // namespace raylab
