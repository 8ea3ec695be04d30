#pragma once

#include "raylab/base/output_file.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace raylab {

/// The bytes of a file. Error where it is missing, no regular file, unreadable or larger than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 32);

/// Writes a file whole or not at all: as a temporary first, then renamed; devices, FIFOs and what symlinks lead to are
/// written themselves. Makes missing folders. Error where it cannot.
void write_file(const OutputFile& file, std::string_view bytes);

/// For writers that want a path: `write` fills a temporary (same extension) that becomes the file.
void write_file_with(const OutputFile& file, const std::function<void(const std::filesystem::path&)>& write);

}  // namespace raylab
