#include "raylab/radiosity/cache/content_hash.h"

#include <fmt/format.h>

#include <cstdint>

namespace raylab {

std::string ContentHash::digits() const {
    return fmt::format("{:016x}{:016x}", static_cast<std::uint64_t>(state_ >> 64), static_cast<std::uint64_t>(state_));
}

}  // namespace raylab
