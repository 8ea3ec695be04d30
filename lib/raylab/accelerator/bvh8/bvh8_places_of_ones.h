#pragma once

#include "raylab/accelerator/bvh8/bvh8_vertices.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace raylab {

/// For each mask of eight bits, which of them are one, the lowest first. What follows them means nothing.
inline constexpr auto bvh8_places_of_ones = [] {
    std::array<std::array<std::uint8_t, bvh8_width>, 1 << bvh8_width> all{};
    for (std::size_t mask = 0; mask < all.size(); ++mask) {
        std::size_t count = 0;
        for (std::uint8_t bit = 0; bit < bvh8_width; ++bit)
            if (mask >> bit & 1) all[mask][count++] = bit;
    }
    return all;
}();

}  // namespace raylab
