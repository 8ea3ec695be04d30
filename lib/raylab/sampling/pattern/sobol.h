#pragma once

#include <cstdint>

namespace raylab {

/// The bits in the opposite order.
constexpr std::uint32_t reversed_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

// The first two dimensions of Sobol's sequence (1967), as Bratley and Fox (ACM TOMS 14(1), 1988) and Joe and Kuo (2003)
// number them. Any 2^k points that begin at a multiple of 2^k have exactly one in each of the 2^k equal rectangles of
// every division into 2^i columns and 2^(k - i) rows. The coordinates are returned with their bits reversed: bit 0 is
// worth 1/2, bit 1 is worth 1/4. That is what scrambling wants (owen_scrambled.h).

/// The first coordinate: the index itself, read backwards (van der Corput, 1935).
constexpr std::uint32_t reversed_sobol_x(std::uint32_t index) { return index; }

/// The second coordinate: bit r is the sum, modulo 2, of all bits c of the index for which the binomial coefficient
/// (c over r) is odd, which is where c contains the binary digits of r. So five steps do: one for each digit of r.
constexpr std::uint32_t reversed_sobol_y(std::uint32_t index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    index ^= (index >> 16) & 0x0000ffffu;
    return index;
}

}  // namespace raylab
