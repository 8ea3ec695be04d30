#pragma once

#include <string>

namespace raylab {

/// A file descriptor that closes itself; programs that are started do not inherit it unless asked to.
class Descriptor {
public:
    explicit Descriptor(int number);  // throws an Error with errno's reason where the number is negative
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

/// A file in memory, positioned at its beginning. Unlike a pipe, it cannot block the writer when its reader never
/// reads.
Descriptor memory_file(const std::string& bytes);

}  // namespace raylab
