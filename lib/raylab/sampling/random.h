#pragma once

#include <cstdint>

// Random numbers as values: they are not drawn from a stream, so nothing depends on the order of work or on other
// draws.

namespace raylab {

/// The identity of a random number. Equal places give equal numbers, in any thread and at any time.
struct RandomPlace {
    std::uint64_t seed = 0;
    std::uint64_t pixel = 0;      // or another counted thing: a ray, a case
    std::uint64_t sample = 0;     // the number of the sample in that pixel
    std::uint64_t dimension = 0;  // the purpose of the number: 0 and 1 are the picture's x and y, ...
};

/// A bijection of 64 bits in which every output bit depends on every input bit (Steele, Lea and Flood, "Fast Splittable
/// Pseudorandom Number Generators", OOPSLA 2014: SplitMix64, with its step between values).
constexpr std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

/// The 64 random bits of a place.
constexpr std::uint64_t random_bits(const RandomPlace& place) {
    return mixed(mixed(mixed(mixed(place.seed) ^ place.pixel) ^ place.sample) ^ place.dimension);
}

/// The random number of a place in [0, 1), a multiple of 2^-53.
constexpr double random_number(const RandomPlace& place) {
    return static_cast<double>(random_bits(place) >> 11) * 0x1p-53;
}

}  // namespace raylab
