#pragma once

#include "raylab/image/compare.h"
#include "raylab/image/picture_files/files.h"

#include "fuzz/memory_file.h"
#include "fuzz/value_or_error.h"

#include <cassert>

// Larger pictures are valid, but slow, so the fuzzer skips files that claim to contain one.
constexpr std::int64_t fuzzed_pixels = 1 << 14;

// A picture that was read must not throw: noexcept ends the fuzzer if it does.
inline void check_picture(const raylab::Image& image) noexcept {
    assert(image.width() >= 1 && image.height() >= 1);
    assert(raylab::compare(image, image).bits_differ == 0);
}

// Any bytes must give a picture that equals itself or an Error.
inline int read_any_picture(const std::uint8_t* data, std::size_t size) {
    return value_or_error(data, size, [](std::string_view bytes) {
        const MemoryFile file(bytes);
        check_picture(raylab::read_image(file.path()));
    });
}
