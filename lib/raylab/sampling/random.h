#pragma once

#include <cstdint>

// Randomness as a value: nothing is drawn from a stream, so nothing depends on the order of work or on who else drew.

namespace raylab {

/// Which random number is meant. Equal places give equal numbers, whoever asks and whenever.
struct RandomPlace {
    std::uint64_t seed = 0;
    std::uint64_t pixel = 0;      // or whatever is counted: a ray, a case
    std::uint64_t sample = 0;     // the how-manieth try of that pixel
    std::uint64_t dimension = 0;  // what the number is for: 0 and 1 the picture's x and y, ...
};

/// A bijection of 64 bits whose every output bit depends on every input bit (Steele, Lea and Flood, "Fast Splittable
/// Pseudorandom Number Generators", OOPSLA 2014: SplitMix64, with its step between values).
constexpr std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

/// 64 random bits for a place.
constexpr std::uint64_t random_bits(const RandomPlace& place) {
    return mixed(mixed(mixed(mixed(place.seed) ^ place.pixel) ^ place.sample) ^ place.dimension);
}

/// A number in [0, 1), a multiple of 2^-53, for a place.
constexpr double random_number(const RandomPlace& place) {
    return static_cast<double>(random_bits(place) >> 11) * 0x1p-53;
}

}  // namespace raylab
