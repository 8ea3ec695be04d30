#pragma once

#include <cstdint>
#include <filesystem>

namespace raylab::grading {

/// The bytes that the files below a folder take on the disk. Those that come or go meanwhile may be counted or not.
std::uintmax_t scratch_size(const std::filesystem::path& folder);

}  // namespace raylab::grading
