#include "raylab/image/png_chunks.h"

#include "raylab/base/bytes.h"

#include <cstddef>
#include <cstdint>

namespace raylab {

namespace {

// CRC-32 of ISO 3309, bit by bit with its reversed polynomial (PNG specification, annex D) over a table of nibbles.
std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t table[16];
    for (std::uint32_t n = 0; n < 16; ++n) {
        table[n] = n;
        for (int bit = 0; bit < 4; ++bit) table[n] = table[n] & 1 ? 0xedb88320u ^ (table[n] >> 1) : table[n] >> 1;
    }
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        crc = table[crc & 15] ^ (crc >> 4);
        crc = table[crc & 15] ^ (crc >> 4);
    }
    return ~crc;
}

}  // namespace

std::string png_damage(std::string_view bytes) {
    constexpr std::size_t signature = 8,
                          frame = 12;  // a chunk is length, type, data and checksum: four bytes each, except the data
    for (std::size_t at = signature; at + frame <= bytes.size();) {
        const std::size_t length = number_at<std::uint32_t>(bytes, at, std::endian::big);
        const std::string_view type = bytes.substr(at + 4, 4);
        if (length > bytes.size() - at - frame) return "one cut short";
        if (checksum(bytes.substr(at + 4, 4 + length)) !=
            number_at<std::uint32_t>(bytes, at + 8 + length, std::endian::big))
            return "a wrong checksum at byte " + std::to_string(at);
        if (type == "IEND") return {};
        at += frame + length;
    }
    return "one cut short";
}

}  // namespace raylab
