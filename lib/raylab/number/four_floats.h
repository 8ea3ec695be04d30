#pragma once

#include <bit>
#include <cstdint>

namespace raylab {

/// Four floats that are computed with at once, in the vector types of GCC and Clang.
using FourFloats [[gnu::vector_size(16)]] = float;
using FourInts [[gnu::vector_size(16)]] = std::int32_t;

inline FourFloats all_four(float x) { return FourFloats{x, x, x, x}; }
inline FourFloats magnitude(FourFloats x) { return std::bit_cast<FourFloats>(std::bit_cast<FourInts>(x) & 0x7fffffff); }
inline FourFloats larger(FourFloats x, FourFloats y) { return x > y ? x : y; }
inline FourFloats smaller(FourFloats x, FourFloats y) { return x < y ? x : y; }

/// A mask of the first three that are negative (or NaN with a negative sign).
inline unsigned three_signs(FourFloats x) {
#ifdef __SSE__
    return static_cast<unsigned>(__builtin_ia32_movmskps(x)) & 7u;
#else
    const auto bits = std::bit_cast<FourInts>(x) < 0;
    return static_cast<unsigned>((bits[0] & 1) | (bits[1] & 2) | (bits[2] & 4));
#endif
}
inline unsigned three_signs(FourInts x) { return three_signs(std::bit_cast<FourFloats>(x)); }

}  // namespace raylab
