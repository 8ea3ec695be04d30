#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cassert>
#include <filesystem>
#include <string>
#include <string_view>

/// A file in memory, for readers that take a path.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
        assert(descriptor_ >= 0);
        [[maybe_unused]] const auto written = write(descriptor_, bytes.data(), bytes.size());
        assert(written == static_cast<ssize_t>(bytes.size()));
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};
