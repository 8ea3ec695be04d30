#include "raylab/base/descriptor.h"

#include "raylab/base/error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace raylab {

Descriptor::Descriptor(int number) : number_(number) {
    if (number < 0) throw Error(std::string("expected a file descriptor, found: ") + std::strerror(errno));
}

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor::~Descriptor() { close(); }

void Descriptor::close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
}

Pipe make_pipe() {
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) ends = {-1, -1};
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Descriptor memory_file(const std::string& bytes) {
    Descriptor file(memfd_create("raylab", MFD_CLOEXEC));
    std::size_t written = 0;
    while (written < bytes.size()) {
        const auto count = write(file.number(), bytes.data() + written, bytes.size() - written);
        if (count < 0 && errno != EINTR) throw Error(std::string("expected memory, found: ") + std::strerror(errno));
        if (count > 0) written += static_cast<std::size_t>(count);
    }
    lseek(file.number(), 0, SEEK_SET);
    return file;
}

}  // namespace raylab
