#pragma once

#include "raylab/base/bytes.h"

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

// Picture files as bytes, with arbitrary claims in their headers.

/// A PNG with one IDAT chunk (PNG specification, chapter 5) and right checksums.
struct PngBytes {
    std::uint32_t width, height;
    std::uint8_t bits = 8, color_type = 2;  // 0: grey, 2: RGB, 3: palette, 4 and 6: with alpha
    std::string lines = {};                 // each line after a byte 0 (no filter); compressed here
    std::string palette = {};

    std::string file() const {
        std::string header;
        raylab::append_number(header, width, std::endian::big);
        raylab::append_number(header, height, std::endian::big);
        header += {static_cast<char>(bits), static_cast<char>(color_type), 0, 0, 0};
        return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + (palette.empty() ? "" : chunk("PLTE", palette)) +
               chunk("IDAT", deflated(lines)) + chunk("IEND", "");
    }

private:
    static std::string chunk(const std::string& type, const std::string& data) {
        std::string bytes;
        raylab::append_number(bytes, static_cast<std::uint32_t>(data.size()), std::endian::big);
        bytes += type + data;
        const auto* begin = reinterpret_cast<const Bytef*>(bytes.data() + 4);
        const auto sum = static_cast<std::uint32_t>(crc32(0, begin, static_cast<uInt>(bytes.size() - 4)));
        raylab::append_number(bytes, sum, std::endian::big);
        return bytes;
    }
    static std::string deflated(const std::string& data) {
        uLongf size = compressBound(static_cast<uLong>(data.size()));
        std::string bytes(size, '\0');
        compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
                 static_cast<uLong>(data.size()));
        return bytes.substr(0, size);
    }
};

/// The header of an EXR file with float channels (OpenEXR File Layout), and zeros instead of chunks.
struct ExrClaim {
    std::int32_t width, height;
    std::vector<std::string> channels = {"B", "G", "R"};
    char compression = 3;         // ZIP
    std::string attributes = {};  // further ones, from attribute()
    std::size_t zeros = 0;

    static std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
        std::string bytes = name + '\0' + type + '\0';
        raylab::append_number(bytes, static_cast<std::int32_t>(value.size()), std::endian::little);
        return bytes + value;
    }
    static std::string integers(const std::vector<std::int32_t>& values) {
        std::string bytes;
        for (const auto value : values) raylab::append_number(bytes, value, std::endian::little);
        return bytes;
    }

    std::string file() const {
        std::string list;
        for (const auto& channel : channels) list += channel + '\0' + integers({2, 0, 1, 1});
        const std::string window = integers({0, 0, width - 1, height - 1});
        return integers({0x01312f76, 2}) + attribute("channels", "chlist", list + '\0') +
               attribute("compression", "compression", {compression}) + attribute("dataWindow", "box2i", window) +
               attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
               attribute("pixelAspectRatio", "float", integers({0x3f800000})) +
               attribute("screenWindowCenter", "v2f", integers({0, 0})) +
               attribute("screenWindowWidth", "float", integers({0x3f800000})) + attributes + '\0' +
               std::string(zeros, '\0');
    }
};
