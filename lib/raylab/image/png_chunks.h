#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// What is wrong with the chunks of a PNG file (PNG specification, section 5): truncated, a wrong checksum, no end.
/// Empty where nothing is. libpng would detect the same, but it also prints a line of its own.
std::string png_damage(std::string_view bytes);

}  // namespace raylab
