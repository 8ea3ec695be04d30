#pragma once

#include "sanitized.h"

#include "raylab/base/process.h"

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

// A run of CI judges with a tenth of the seeds, another tenth after each commit; `raylab test --all` with all of them.

inline bool all_are_tested() { return std::getenv("RAYLAB_TEST_ALL") != nullptr; }

/// The number of commits, which chooses the tenth; 0 without a repository.
inline std::uint64_t commits() {
    static const std::uint64_t count = [] {
        const auto counted = raylab::run_process("git", {"-C", RAYLAB_SOURCE, "rev-list", "--count", "HEAD"});
        return counted.succeeded() ? std::stoull(counted.output) : 0;
    }();
    return count;
}

/// Of the seeds 1 to `most`, a multiple of 10, those of this run. Under a sanitizer, which is slow, it is one.
inline std::vector<std::uint64_t> seeds_of_this_run(std::uint64_t most) {
    std::vector<std::uint64_t> seeds;
    for (std::uint64_t seed = 1; seed <= (is_sanitized ? 10 : most); ++seed)
        if (all_are_tested() || seed % 10 == commits() % 10) seeds.push_back(seed);
    return seeds;
}
