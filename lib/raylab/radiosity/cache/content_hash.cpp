#include "raylab/radiosity/cache/content_hash.h"

#include <fmt/format.h>

namespace raylab {

std::string ContentHash::digits() const {
    const auto number = XXH3_128bits_digest(&state_);
    return fmt::format("{:016x}{:016x}", number.high64, number.low64);
}

}  // namespace raylab
