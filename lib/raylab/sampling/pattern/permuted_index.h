#pragma once

#include <bit>
#include <cstdint>

namespace raylab {

/// Where a permutation of 0, 1, ..., count - 1 sends an index; `key` says which permutation. Nothing is stored: a
/// bijection of the next power of two is repeated until its result is below count, which takes less than two steps on
/// average (cycle walking: Black and Rogaway, "Ciphers with Arbitrary Finite Domains", 2002). Each round is an odd
/// factor, a sum, and a shift that brings high bits down; after six, two indices meet any two places equally often to
/// 3 %. `count` is at most 2^31.
constexpr std::uint32_t permuted_index(std::uint32_t index, std::uint32_t count, std::uint64_t key) {
    constexpr int rounds = 6;
    const auto bits = static_cast<int>(std::bit_width(count - 1));
    const std::uint32_t mask = (std::uint32_t{1} << bits) - 1;
    const int down = (bits + 1) / 2;
    do {
        std::uint64_t stream = key;
        for (int round = 0; round < rounds; ++round) {
            const auto some = static_cast<std::uint32_t>(stream >> 32);
            index = (index * (some | 1) + (some >> 7)) & mask;
            index ^= index >> down;
            stream = stream * 6364136223846793005u + 1442695040888963407u;  // Knuth's generator, MMIX
        }
    } while (index >= count);
    return index;
}

}  // namespace raylab
