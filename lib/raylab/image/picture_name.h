#pragma once

#include <filesystem>

namespace raylab {

/// Error where write_image() would refuse the name: it ends neither in .exr nor in .png. For whoever works long before a
/// picture is written.
void check_picture_name(const std::filesystem::path& path);

}  // namespace raylab
