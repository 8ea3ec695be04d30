#pragma once

#include "raylab/sampling/pattern/fraction.h"
#include "raylab/sampling/random.h"

#include <cstdint>

namespace raylab {

/// The digits of an index in a base, read backwards behind the point: 6 is 110 in base 2, and 0.011 is 3/8 (Halton, "On
/// the Efficiency of Certain Quasi-Random Sequences", 1960). Dimension d of Halton's sequence is that of the d-th
/// prime. Weak spot: two large bases step almost together, so their first points lie on a few lines.
constexpr double radical_inverse(std::uint32_t base, std::uint32_t index) {
    double inverse = 0, worth = 1;
    for (; index > 0; index /= base) {
        worth /= base;
        inverse += worth * (index % base);
    }
    return inverse;
}

/// The same with each digit turned round by a number that the more valuable digits and `key` determine, and random
/// digits behind those that `count` indices need: every interval of base^-k has as many points as before. (Owen's
/// scrambling, with turns in the place of all permutations of a digit.) The base is fixed, so that no division is
/// computed.
template <std::uint32_t base>
constexpr double scrambled_radical_inverse(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    double inverse = 0, worth = 1;
    for (std::uint64_t largest = 1; largest < count; largest *= base) {
        const std::uint32_t digit = index % base;
        const auto turn = static_cast<std::uint32_t>((std::uint64_t{low_half(key)} * base) >> 32);
        const std::uint32_t turned = digit + turn < base ? digit + turn : digit + turn - base;
        index /= base;
        worth /= base;
        inverse += worth * turned;
        key = mixed(key ^ (digit + 1));
    }
    return in_cell(inverse, worth * fraction(low_half(key)), 1);
}

}  // namespace raylab
