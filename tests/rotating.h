#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

// What takes long and is many of one kind is tested in parts. A run takes one, and `./raylab test --all` takes all.

inline bool all_are_tested() { return std::getenv("RAYLAB_TEST_ALL") != nullptr; }

/// The number that chooses the part. `./raylab test` counts it: each part has three commits, in which all that takes
/// turns (sanitizers, programs) has its own. 0 where a test runs by hand.
inline std::uint64_t test_round() {
    const char* const round = std::getenv("RAYLAB_TEST_ROUND");
    return round != nullptr ? std::stoull(round) : 0;
}

/// Whether the i-th of many is tested in this run, which takes one of so many parts.
inline bool is_tested_now(std::uint64_t i, std::uint64_t parts) {
    return all_are_tested() || i % parts == test_round() % parts;
}
