#pragma once

#include <cstdint>
#include <filesystem>

namespace raylab::grading {

/// The bounds of one process, by setrlimit(2). Processes are counted for each user, so only a user of its own has few.
struct Limits {
    unsigned seconds;      // of processor time
    std::uint64_t memory;  // bytes of address space
    std::uint64_t file;    // bytes of each file that is written
    unsigned processes;    // and threads
    unsigned open_files = 64;
};

/// Bounds this process, and each that it starts. It throws std::system_error where the kernel refuses.
void bound(const Limits& limits);

/// For root only: the folder, with all in it, is given to this user and group, and the process becomes that user.
void become_user(unsigned id, const std::filesystem::path& folder);

}  // namespace raylab::grading
