#include "fuzz/any_picture.h"

#include <zlib.h>

#include <algorithm>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

std::uint32_t big_endian(const std::uint8_t* four) {
    return std::uint32_t{four[0]} << 24 | std::uint32_t{four[1]} << 16 | std::uint32_t{four[2]} << 8 | four[3];
}

// Gives every complete chunk (length, type, data, checksum) the right checksum for its type and data.
void mend_checksums(std::uint8_t* data, std::size_t size) {
    constexpr std::size_t signature = 8, frame = 12;
    for (std::size_t at = signature; at + frame <= size;) {
        const std::size_t length = big_endian(data + at);
        if (length > size - at - frame) return;
        const auto checksum = static_cast<std::uint32_t>(crc32(0, data + at + 4, static_cast<uInt>(length + 4)));
        for (std::size_t i = 0; i < 4; ++i)
            data[at + 8 + length + i] = static_cast<std::uint8_t>(checksum >> (24 - 8 * i));
        at += frame + length;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t width = 16, height = 20;  // their offsets, where IHDR is the first chunk
    if (size >= height + 4 &&
        std::uint64_t{big_endian(data + width)} * big_endian(data + height) > std::uint64_t{fuzzed_pixels})
        return -1;
    return read_any_picture(data, size);
}

// A mutated chunk has a wrong checksum and would not be read further, so it is corrected seven times in eight.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
    const std::size_t mutated = LLVMFuzzerMutate(data, size, largest);
    if (seed % 8 != 0) mend_checksums(data, mutated);
    return mutated;
}
