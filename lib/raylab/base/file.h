#pragma once

#include "raylab/base/output_file.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace raylab {

/// Reads a file. It throws an Error where the file is missing, not a regular file, unreadable or larger than `limit`
/// bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 32);

/// Writes a file whole or not at all: first to a temporary file, which is then renamed. Devices, FIFOs and the targets
/// of symlinks are written directly. Missing folders are created. It throws an Error where it fails.
void write_file(const OutputFile& file, std::string_view bytes);

/// For writers that need a path: `write` fills a temporary file (with the same extension), which then becomes the file.
void write_file_with(const OutputFile& file, const std::function<void(const std::filesystem::path&)>& write);

}  // namespace raylab
