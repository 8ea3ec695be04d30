#pragma once

#include <algorithm>
#include <cstdint>

namespace raylab {

/// 32 bits as a number in (0, 1): the middle of their interval of 2^-32, so a mapping never meets 0 or 1.
constexpr double fraction(std::uint32_t bits) { return (bits + 0.5) * 0x1p-32; }

/// The halves of 64 random bits are independent.
constexpr std::uint32_t low_half(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }
constexpr std::uint32_t high_half(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }

/// The place (cell + inside) / cells. The last of 2^30 cells would be rounded up to 1.
constexpr double in_cell(double cell, double inside, double cells) {
    return std::min((cell + inside) / cells, 1 - 0x1p-53);
}

}  // namespace raylab
