#pragma once

#include "raylab/base/error.h"

#include <cstdint>
#include <string>
#include <string_view>

// A small file can demand much memory: a picture's header any number of pixels, an instance a whole mesh. A reader of
// such a file predicts what it needs and refuses the file before the memory is allocated.

namespace raylab {

/// Half of the machine's memory or, if less, of what its control group allows, in bytes.
std::uint64_t half_of_memory();

/// The number of bytes that may be allocated for what a file demands.
struct MemoryLimit {
    std::uint64_t bytes = half_of_memory();
};

/// The limit for what is read next, after `taken` bytes of it were used.
MemoryLimit what_is_left(const MemoryLimit& limit, double taken);

/// The memory that a file demands.
struct MemoryNeed {
    double bytes;      // a prediction; a double, because products of numbers in files overflow integers
    std::string what;  // "a picture"
    std::string why;   // "256 channels x 16384 x 16384 floats"
};

/// Throws an Error where the need exceeds the limit: "expected at most 4.0 GiB (--memory), found a picture that needs
/// 17.2 GiB: 256 channels x 16384 x 16384 floats".
void check_memory(const MemoryNeed& need, const MemoryLimit& limit, const Place& place);

/// Reads "4G", "512M", "100K" or bytes. It throws an Error for anything else.
MemoryLimit memory_limit_from_words(std::string_view words);

/// "4.0 GiB", "17 bytes".
std::string bytes_in_words(double bytes);

}  // namespace raylab
