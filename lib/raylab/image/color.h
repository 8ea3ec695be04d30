#pragma once

#include "raylab/image/image.h"

#include <cmath>
#include <cstdint>

// Conversions between linear light, in which everything is computed, and the sRGB code values of files and screens.

namespace raylab {

/// The linear light in [0, 1] of an sRGB code value in [0, 1]. IEC 61966-2-1, equations (5) and (6).
inline double linear_from_srgb(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

/// The sRGB code value in [0, 1] of linear light in [0, 1]. IEC 61966-2-1, equations (9) and (10).
inline double srgb_from_linear(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

/// Clamps to [0, 1]; NaN becomes 0.
inline double unit_clamped(double value) {
    if (!(value > 0)) return 0;
    return value < 1 ? value : 1;
}

/// The nearest of the 256 code values of an 8-bit picture.
inline std::uint8_t srgb_byte(double light) {
    return static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(unit_clamped(light))));
}

/// Relative luminance Y. Rec. 709 primaries, D65.
inline double luminance(const Pixel& pixel) { return 0.2126 * pixel.r + 0.7152 * pixel.g + 0.0722 * pixel.b; }

/// The colour with these sRGB code values (0 to 255), in the notation of drawing programs: pixel_from_srgb(213, 94, 0).
inline Pixel pixel_from_srgb(int r, int g, int b) {
    const auto linear = [](int code) { return static_cast<float>(linear_from_srgb(code / 255.0)); };
    return {linear(r), linear(g), linear(b)};
}

/// Multiplies every value by 2^stops: the picture that a camera with that much more exposure would take.
inline Image exposed(const Image& image, double stops) {
    const auto factor = static_cast<float>(std::exp2(stops));
    Image result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Pixel& from = image.at(x, y);
            result.at(x, y) = {factor * from.r, factor * from.g, factor * from.b};
        }
    return result;
}

}  // namespace raylab
