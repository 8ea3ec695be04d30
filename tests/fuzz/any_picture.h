#pragma once

#include "raylab/image/compare.h"
#include "raylab/image/files.h"

#include "fuzz/memory_file.h"
#include "fuzz/value_or_error.h"

#include <cassert>

// Pictures of more pixels are legal, and slow: a fuzzer passes over what claims to be one.
constexpr std::int64_t fuzzed_pixels = 1 << 14;

// What was read is no Error: noexcept ends the fuzzer.
inline void check_picture(const raylab::Image& image) noexcept {
    assert(image.width() >= 1 && image.height() >= 1);
    assert(raylab::compare(image, image).bits_differ == 0);
}

// Any bytes are a picture that equals itself or an Error.
inline int read_any_picture(const std::uint8_t* data, std::size_t size) {
    return value_or_error(data, size, [](std::string_view bytes) {
        const MemoryFile file(bytes);
        check_picture(raylab::read_image(file.path()));
    });
}
