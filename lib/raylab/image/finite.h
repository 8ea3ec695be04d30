#pragma once

#include "raylab/image/image.h"

#include <cmath>
#include <optional>

namespace raylab {

/// A pixel with its position.
struct PixelAt {
    int x, y;
    Pixel value;
};

inline bool is_finite(const Pixel& pixel) {
    return std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b);
}

/// The first pixel, in reading order, that has a NaN or an infinity; absent where none has.
inline std::optional<PixelAt> first_non_finite(const Image& image) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (!is_finite(image.at(x, y))) return PixelAt{x, y, image.at(x, y)};
    return std::nullopt;
}

}  // namespace raylab
