#pragma once

#include "raylab/image/image.h"

#include <cstdint>
#include <vector>

namespace raylab {

/// srgb_byte() of every value of a picture, row after row, by a table instead of std::pow.
std::vector<std::uint8_t> srgb_bytes(const Image& image);

}  // namespace raylab
