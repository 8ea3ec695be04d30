#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace raylab {

/// The bytes of a file. Error where it is missing, no regular file, unreadable or larger than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 32);

/// Writes a file whole or not at all: beside it first, then renamed. Makes missing folders. Error where it cannot.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// For writers that want a path: `write` fills a temporary file beside `path` (same extension), which is then renamed.
void write_file_with(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

}  // namespace raylab
