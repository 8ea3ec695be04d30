#pragma once

#include "level.h"
#include "system_calls.h"

#include "raylab/base/process.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab::grading {

/// What runs a program apart from everything else.
struct Isolated {
    Isolation isolation;
    std::filesystem::path folder;  // its scratch: of all files, a compiler can write these alone
};

/// What a program is run for, and how long it may take.
struct Allowed {
    Work work;
    unsigned seconds;  // of the processor, which decides: it does not depend on what else runs

    /// Seconds of the clock, for a program that only waits, or gets a small share of the processor.
    double patience() const { return 4.0 * seconds + 2; }
};

/// Runs foreign code, or a compiler on it, as run_process() does; the timeout is that of `allowed`. The program is
/// given by its path. What fills its folder with more than 256 MB is killed. It throws an Error where the isolation
/// cannot be had: nothing runs without it.
ProcessResult run_isolated(const Isolated& isolated, const Allowed& allowed, const std::filesystem::path& program,
                           const std::vector<std::string>& words, ProcessOptions options = {});

}  // namespace raylab::grading
