#include "raylab/report/page/pixel_values.h"

#include "raylab/base/base64.h"
#include "raylab/image/picture_files/files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace raylab {

namespace {

// Three mantissas and their exponent, as they are stored. Floats below 2^-120 are stored as zero.
std::array<std::uint8_t, 4> shared_exponent(const Pixel& pixel) {
    const float largest = std::max({pixel.r, pixel.g, pixel.b});
    if (!(largest > 0x1p-120f)) return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(largest, &exponent);  // largest < 2^exponent
    const auto mantissa = [&](float value) {
        const float scaled = std::floor(std::ldexp(std::max(0.0f, value), 8 - exponent) + 0.5f);
        return static_cast<std::uint8_t>(std::min(255.0f, scaled));
    };
    return {mantissa(pixel.r), mantissa(pixel.g), mantissa(pixel.b), static_cast<std::uint8_t>(exponent + 128)};
}

}  // namespace

std::string pixel_values_script(const Image& image) {
    std::vector<std::uint8_t> mantissas, exponents;
    for (const Pixel& pixel : image.pixels()) {
        const auto stored = shared_exponent(pixel);
        mantissas.insert(mantissas.end(), stored.begin(), stored.begin() + 3);
        exponents.insert(exponents.end(), 3, stored[3]);
    }
    mantissas.insert(mantissas.end(), exponents.begin(), exponents.end());
    return "raylab_values(\"data:image/png;base64," + base64(png_bytes(image.width(), 2 * image.height(), mantissas)) +
           "\");\n";
}

std::string pixel_values_file(const std::string& picture) {
    return std::filesystem::path(picture).stem().string() + "_values.js";
}

}  // namespace raylab
