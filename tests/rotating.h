#pragma once

#include "raylab/base/process.h"

#include <cstdint>
#include <cstdlib>
#include <string>

// What takes long and is many of one kind is tested in parts: a run takes one, and the next commit's run another;
// `./raylab test --all` takes all.

inline bool all_are_tested() { return std::getenv("RAYLAB_TEST_ALL") != nullptr; }

/// The number of commits, which chooses the part; 0 without a repository.
inline std::uint64_t commits() {
    static const std::uint64_t count = [] {
        const auto counted = raylab::run_process("git", {"-C", RAYLAB_SOURCE, "rev-list", "--count", "HEAD"});
        return counted.succeeded() ? std::stoull(counted.output) : 0;
    }();
    return count;
}

/// Whether the i-th of many is tested in this run, which takes one of so many parts.
inline bool is_tested_now(std::uint64_t i, std::uint64_t parts) {
    return all_are_tested() || i % parts == commits() % parts;
}
