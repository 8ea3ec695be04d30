#pragma once

#include <cstdint>

namespace raylab {

/// The part of a surface of revolution that is hit; every other shape is all side.
enum class Part : std::uint8_t { side = 0, base_cap = 1, top_cap = 2 };

}  // namespace raylab
