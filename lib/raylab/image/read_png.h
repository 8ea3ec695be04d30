#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/image/image.h"

#include <string>
#include <string_view>

namespace raylab {

/// The colours of a PNG, decoded from sRGB: 1 to 16 bits, grey, RGB or palette; alpha is not looked at. Error, naming
/// `file`, for a damaged one and, before memory is taken, for more pixels than the limit has room for.
Image read_png(std::string_view bytes, const std::string& file, const MemoryLimit& limit);

}  // namespace raylab
