#pragma once

#include <filesystem>

namespace raylab {

/// Throws an Error where write_image() would refuse the name, which must end in .exr or .png, so that a long
/// computation before it is not wasted.
void check_picture_name(const std::filesystem::path& path);

}  // namespace raylab
