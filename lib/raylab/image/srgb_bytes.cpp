#include "raylab/image/srgb_bytes.h"

#include "raylab/image/color.h"

#include <algorithm>
#include <array>
#include <bit>

namespace raylab {

namespace {

/// The smallest float in (0, 1] with that code value, found by bisection over the floats' bits: srgb_byte() never
/// decreases, and positive floats have the order of their bits.
float min_light(std::uint8_t code) {
    auto below = std::bit_cast<std::uint32_t>(0.0f), reached = std::bit_cast<std::uint32_t>(1.0f);
    while (reached - below > 1) {
        const std::uint32_t between = below + (reached - below) / 2;
        (srgb_byte(std::bit_cast<float>(between)) < code ? below : reached) = between;
    }
    return std::bit_cast<float>(reached);
}

class SrgbTable {
public:
    SrgbTable() {
        for (int code = 1; code < 256; ++code)
            least_[static_cast<std::size_t>(code)] = min_light(static_cast<std::uint8_t>(code));
        for (std::size_t cell = 0; cell <= cells; ++cell) lowest_[cell] = srgb_byte(static_cast<double>(cell) / cells);
    }

    std::uint8_t byte(float light) const {
        const auto clamped = static_cast<float>(unit_clamped(light));
        const std::uint8_t code = lowest_[static_cast<std::size_t>(clamped * cells)];
        return code < 255 && clamped >= least_[code + 1u] ? static_cast<std::uint8_t>(code + 1) : code;
    }

private:
    // Steps between code values are at least 1 / (255 * 12.92) apart, so that a cell contains at most one.
    static constexpr std::size_t cells = 4096;
    std::array<float, 256> least_{};
    std::array<std::uint8_t, cells + 1> lowest_{};
};

}  // namespace

std::vector<std::uint8_t> srgb_bytes(const Image& image) {
    static const SrgbTable table;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * image.pixels().size());
    for (const Pixel& pixel : image.pixels())
        for (const float light : {pixel.r, pixel.g, pixel.b}) bytes.push_back(table.byte(light));
    return bytes;
}

}  // namespace raylab
