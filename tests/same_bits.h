#pragma once

#include "raylab/image/image.h"

#include <cstring>

/// Whether two pictures are the same, bit by bit: a NaN equals itself, and -0 differs from 0.
inline bool same_bits(const raylab::Image& a, const raylab::Image& b) {
    return a.width() == b.width() && a.height() == b.height() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size() * sizeof(raylab::Pixel)) == 0;
}
