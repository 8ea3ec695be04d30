#include "scratch_size.h"

#include <sys/stat.h>

#include <system_error>

namespace raylab::grading {

namespace fs = std::filesystem;

std::uintmax_t scratch_size(const fs::path& folder) {
    constexpr std::uintmax_t block_bytes = 512;  // stat(2) counts in these
    std::uintmax_t bytes = 0;
    std::error_code gone;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, gone), end;
    while (!gone && entry != end) {
        struct stat found {};
        if (lstat(entry->path().c_str(), &found) == 0)
            bytes += static_cast<std::uintmax_t>(found.st_blocks) * block_bytes;
        entry.increment(gone);
    }
    return bytes;
}

}  // namespace raylab::grading
