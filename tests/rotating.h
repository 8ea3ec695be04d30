#pragma once

#include "raylab/base/process.h"

#include <cstdint>
#include <cstdlib>
#include <string>

// What takes long and is many of one kind is tested in parts. A run takes one, and `./raylab test --all` takes all.
// Each part has the turn of two commits, since the sanitizers take turns, too (`raylab`): of an even number of parts,
// one that came with every commit would meet half of them alone.

inline bool all_are_tested() { return std::getenv("RAYLAB_TEST_ALL") != nullptr; }

/// The number of pairs of commits, which chooses the part; 0 without a repository.
inline std::uint64_t turn() {
    static const std::uint64_t count = [] {
        const auto counted = raylab::run_process("git", {"-C", RAYLAB_SOURCE, "rev-list", "--count", "HEAD"});
        return counted.succeeded() ? std::stoull(counted.output) / 2 : 0;
    }();
    return count;
}

/// Whether the i-th of many is tested in this run, which takes one of so many parts.
inline bool is_tested_now(std::uint64_t i, std::uint64_t parts) {
    return all_are_tested() || i % parts == turn() % parts;
}
