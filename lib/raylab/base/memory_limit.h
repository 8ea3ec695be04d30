#pragma once

#include "raylab/base/error.h"

#include <cstdint>
#include <string>
#include <string_view>

// A small file can ask for much memory: a picture's header for any number of pixels, an instance for a whole mesh. Who
// reads such a file forecasts what it needs, and refuses before the memory is taken.

namespace raylab {

/// Half of the machine's memory, or of what its control group allows where that is less, in bytes.
std::uint64_t half_of_memory();

/// How many bytes may be taken for what a file asks for.
struct MemoryLimit {
    std::uint64_t bytes = half_of_memory();
};

/// The limit for what is read next, where so many bytes of it are taken.
MemoryLimit what_is_left(const MemoryLimit& limit, double taken);

/// What a file asks for.
struct MemoryNeed {
    double bytes;      // a forecast; double, as products of what files claim overflow whole numbers
    std::string what;  // "a picture"
    std::string why;   // "256 channels x 16384 x 16384 floats"
};

/// Error where the need is beyond the limit: "expected at most 4.0 GiB (--memory), found a picture that needs 17.2 GiB:
/// 256 channels x 16384 x 16384 floats".
void check_memory(const MemoryNeed& need, const MemoryLimit& limit, const Place& place);

/// "4G", "512M", "100K" or bytes. Error for anything else.
MemoryLimit memory_limit_from_words(std::string_view words);

/// "4.0 GiB", "17 bytes".
std::string bytes_in_words(double bytes);

}  // namespace raylab
