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

/// Runs foreign code, or a compiler on it, as run_process() does. The program is given by its path. It throws an Error
/// where the isolation cannot be had: nothing runs without it.
ProcessResult run_isolated(const Isolated& isolated, Work work, const std::filesystem::path& program,
                           const std::vector<std::string>& words, const ProcessOptions& options);

}  // namespace raylab::grading
