#pragma once

#include "raylab/base/error.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Any bytes must give a value or an Error: `read` is called with them, and any other exception ends the fuzzer.
template <std::invocable<std::string_view> Read>
int value_or_error(const std::uint8_t* data, std::size_t size, Read read) {
    try {
        read({reinterpret_cast<const char*>(data), size});
    } catch (const raylab::Error&) {
    }
    return 0;
}
