#pragma once

#include "raylab/image/image.h"

#include <cstdint>
#include <cstring>
#include <string>

/// The bytes of an uncompressed EXR file with any values, including those that are not finite, which write_image()
/// refuses. (OpenEXR File Layout: magic, version, attributes, one offset for each scan line, the lines with their
/// channels B, G, R.)
inline std::string plain_exr(const raylab::Image& image) {
    std::string bytes;
    const auto raw = [&](const auto& value) {
        char buffer[sizeof value];
        std::memcpy(buffer, &value, sizeof value);  // little-endian, as the format requires and the machine is
        bytes.append(buffer, sizeof value);
    };
    const auto attribute = [&](const std::string& name, const std::string& type, std::int32_t size) {
        bytes += name + '\0' + type + '\0';
        raw(size);
    };
    const std::int32_t right = image.width() - 1, bottom = image.height() - 1, none = 0, one = 1, is_float = 2;
    raw(std::uint32_t{0x01312f76});
    raw(std::uint32_t{2});
    attribute("channels", "chlist", 3 * 18 + 1);
    for (const char channel : {'B', 'G', 'R'}) {
        bytes += std::string{channel} + '\0';
        for (const std::int32_t value : {is_float, none, one, one}) raw(value);
    }
    bytes += '\0';
    attribute("compression", "compression", 1);
    bytes += '\0';
    for (const char* window : {"dataWindow", "displayWindow"}) {
        attribute(window, "box2i", 16);
        for (const std::int32_t value : {none, none, right, bottom}) raw(value);
    }
    attribute("lineOrder", "lineOrder", 1);
    bytes += '\0';
    attribute("pixelAspectRatio", "float", 4);
    raw(1.0f);
    attribute("screenWindowCenter", "v2f", 8);
    raw(0.0f), raw(0.0f);
    attribute("screenWindowWidth", "float", 4);
    raw(1.0f);
    bytes += '\0';
    const std::int32_t line = 12 * image.width();
    const std::uint64_t first = bytes.size() + 8 * static_cast<std::uint64_t>(image.height());
    for (int y = 0; y < image.height(); ++y)
        raw(first + static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(8 + line));
    for (std::int32_t y = 0; y < image.height(); ++y) {
        raw(y), raw(line);
        for (float raylab::Pixel::*channel : {&raylab::Pixel::b, &raylab::Pixel::g, &raylab::Pixel::r})
            for (int x = 0; x < image.width(); ++x) raw(image.at(x, y).*channel);
    }
    return bytes;
}
