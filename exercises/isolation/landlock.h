#pragma once

#include <filesystem>
#include <vector>

// Landlock, the kernel's access control that a process lays on itself (Documentation/userspace-api/landlock.rst).

namespace raylab::grading {

/// The version of the kernel's interface; 0 where it has none.
int landlock_version();

/// The files and folders that stay open to a process.
struct OpenFiles {
    std::vector<std::filesystem::path> readable;  // and executable
    std::vector<std::filesystem::path> writable;
};

/// Closes all other files to this process and those that it starts, and, as far as the version knows them, TCP,
/// abstract sockets and signals to other processes. It throws std::system_error where the kernel refuses.
void close_other_files(const OpenFiles& open);

}  // namespace raylab::grading
