#pragma once

#include <array>
#include <cstddef>
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

/// A later coordinate. Each bit of the index adds its direction number, modulo 2, and a recurrence over a primitive
/// polynomial makes those. The sums of each byte of the index are made when the program is compiled.
class SobolCoordinate {
public:
    /// From the polynomial's coefficients between its first and last, read as a binary number, and the first odd
    /// numbers m of the recurrence, as Joe and Kuo's tables have them; m[i] / 2^(i + 1) is the direction of bit i.
    template <std::size_t degree>
    constexpr SobolCoordinate(std::uint32_t coefficients, const std::array<std::uint32_t, degree>& m) {
        std::array<std::uint32_t, 32> directions{};
        for (std::size_t i = 0; i < 32; ++i) {
            if (i < degree) {
                directions[i] = m[i] << (31 - i);
                continue;
            }
            directions[i] = directions[i - degree] ^ (directions[i - degree] >> degree);
            for (std::size_t k = 1; k < degree; ++k)
                if ((coefficients >> (degree - 1 - k) & 1) != 0) directions[i] ^= directions[i - k];
        }
        for (std::size_t byte = 0; byte < 4; ++byte)
            for (std::size_t value = 1; value < 256; ++value)
                for (std::size_t bit = 0; bit < 8; ++bit)
                    if ((value >> bit & 1) != 0) sums_[byte][value] ^= reversed_bits(directions[8 * byte + bit]);
    }

    constexpr std::uint32_t reversed(std::uint32_t index) const {
        return sums_[0][index & 255] ^ sums_[1][index >> 8 & 255] ^ sums_[2][index >> 16 & 255] ^ sums_[3][index >> 24];
    }

private:
    std::array<std::array<std::uint32_t, 256>, 4> sums_{};
};

/// The third and the fourth, of the polynomials x^2 + x + 1 and x^3 + x + 1.
inline constexpr SobolCoordinate third_sobol(1, std::array<std::uint32_t, 2>{1, 3});
inline constexpr SobolCoordinate fourth_sobol(1, std::array<std::uint32_t, 3>{1, 3, 1});

}  // namespace raylab
