#pragma once

#include <string>

namespace raylab {

/// A file descriptor that closes itself, and that no program we start inherits unasked.
class Descriptor {
public:
    explicit Descriptor(int number);  // Error, by errno, where it is negative
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor();

    int number() const { return number_; }
    void close();

private:
    int number_;
};

struct Pipe {
    Descriptor read, write;
};

Pipe make_pipe();

/// A file in memory to be read from its beginning. Unlike a pipe, a reader that never reads cannot block us.
Descriptor memory_file(const std::string& bytes);

}  // namespace raylab
