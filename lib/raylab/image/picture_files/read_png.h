#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/image/image.h"

#include <string>
#include <string_view>

namespace raylab {

/// The colours of a PNG, decoded from sRGB: 1 to 16 bits, grey, RGB or palette; alpha is ignored. It throws an Error,
/// naming `file`, for a damaged file and, before allocating, for more pixels than the limit permits.
Image read_png(std::string_view bytes, const std::string& file, const MemoryLimit& limit);

}  // namespace raylab
