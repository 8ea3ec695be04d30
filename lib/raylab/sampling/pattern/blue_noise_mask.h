#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// A square of pixels, each with a number of its own, in which neighbours differ much: the pixels below any threshold
/// are spread evenly, without a lattice. It repeats in x and y. (Ulichney, "The Void-and-Cluster Method for Dither
/// Array Generation", SPIE 1913, 1993.)
class BlueNoiseMask {
public:
    static constexpr std::uint32_t side = 64;             // pixels
    static constexpr std::uint32_t pixels = side * side;  // and so many ranks

    /// The one mask of the lab, made when it is first asked for (about 30 ms).
    static const BlueNoiseMask& instance();

    /// 0 to pixels - 1.
    std::uint32_t rank(std::uint32_t x, std::uint32_t y) const { return ranks_[y % side * side + x % side]; }

private:
    BlueNoiseMask();

    std::array<std::uint16_t, pixels> ranks_{};
};

}  // namespace raylab
