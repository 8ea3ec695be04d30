#pragma once

#include "catch.h"

#include "raylab/base/descriptor.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <iterator>
#include <string>

/// The bytes that the reader of a new FIFO receives while `write` writes to it; none where `write` writes elsewhere.
inline std::string read_through_fifo(const std::filesystem::path& fifo, const std::function<void()>& write) {
    REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
    // A second writer, so that the reader neither waits for one nor ends before the first one opens the FIFO.
    raylab::Descriptor held(open(fifo.c_str(), O_RDWR | O_CLOEXEC));
    std::ifstream file(fifo);
    auto reader = std::async(std::launch::async, [&] { return std::string(std::istreambuf_iterator<char>(file), {}); });
    write();
    held.close();
    return reader.get();
}
