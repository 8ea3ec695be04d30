#pragma once

#include <cstdint>

namespace raylab {

/// The part of a surface of revolution that is hit; every other shape is all side.
//
// It is as wide as the numbers beside it in a hit: copies read them all as words, and to read a word of which one byte
// was just written takes the processor some fifteen cycles.
enum class Part : std::uint64_t { side = 0, base_cap = 1, top_cap = 2 };

}  // namespace raylab
