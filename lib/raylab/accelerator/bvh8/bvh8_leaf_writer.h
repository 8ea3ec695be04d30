#pragma once

#include "raylab/accelerator/bvh8/bvh8_vertices.h"
#include "raylab/base/large_pages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace raylab {

/// Finds the vertices that the triangles of a leaf share, and appends the leaf to those already written.
class Bvh8LeafWriter {
public:
    Bvh8LeafWriter() { places_.fill(Bvh8Vertices::largest); }

    void add(const Triangle& triangle, std::uint32_t number, Sides sides) {
        corners_[triangles_] = {vertex(triangle.a), vertex(triangle.b), vertex(triangle.c)};
        sides_[triangles_] = sides;
        numbers_[triangles_++] = number;
    }

    /// Returns the line at which the leaf begins.
    std::size_t append_to(LargeVector<Bvh8Line>& lines) const {
        const std::size_t first = lines.size(), count = std::max(count_, bvh8_width);
        lines.resize(first + Bvh8Vertices::lines(count, triangles_));
        lines.back().floats.fill(0);  // where nothing else comes
        float* at = lines[first].floats.data();
        for (std::size_t i = 0; i < bvh8_width; i += 2)
            at[i / 2] = std::bit_cast<float>(word(i, count) | word(i + 1, count) << 16);
        at[Bvh8Vertices::header - 1] = std::bit_cast<float>(static_cast<std::uint32_t>(count));
        at += Bvh8Vertices::header;
        for (const auto& row : rows_) {
            std::memcpy(at, row.data(), count * sizeof(float));
            at += count;
        }
        std::memcpy(at, numbers_.data(), triangles_ * sizeof(float));
        return first;
    }

private:
    using Place = std::uint16_t;  // (writes through a byte type may alias everything, which prevents optimisation)

    // The place of a vertex with these bits; a new vertex gets the next place. (The one branch is seldom mispredicted:
    // whether another vertex has the same hash.)
    Place vertex(const Vec3f& v) {
        const std::array<std::uint32_t, 3> bits{std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
                                                std::bit_cast<std::uint32_t>(v.z)};
        for (std::size_t axis = 0; axis < 3; ++axis) rows_[axis][count_] = bits[axis];
        std::size_t hash = (bits[0] * 0x9e3779b1 + bits[1] * 0x85ebca6b + bits[2] * 0xc2b2ae35) >> (32 - hash_bits);
        std::size_t place = std::min<std::size_t>(places_[hash], count_);
        while (rows_[0][place] != bits[0] || rows_[1][place] != bits[1] || rows_[2][place] != bits[2]) {
            hash = (hash + 1) % places_.size();
            place = std::min<std::size_t>(places_[hash], count_);
        }
        places_[hash] = static_cast<Place>(place);
        count_ += place == count_;
        return static_cast<Place>(place);
    }

    // The lanes of a triangle's corners and its sides, packed into one word.
    std::uint32_t word(std::size_t place, std::size_t count) const {
        if (place >= triangles_) return 0;
        std::size_t word = sides_[place] == Sides::front ? Bvh8Vertices::front_only : 0;
        for (std::size_t i = 0; i < 3; ++i)
            word |= Bvh8Vertices::lane(corners_[place][i], count) << (Bvh8Vertices::lane_bits * i);
        return static_cast<std::uint32_t>(word);
    }

    static constexpr int hash_bits = 6;
    std::size_t count_ = 0, triangles_ = 0;
    std::array<Place, 1 << hash_bits> places_;  // by hash; `most` where there is none yet
    // The last one is scratch space and never kept.
    std::array<std::array<std::uint32_t, Bvh8Vertices::largest + 1>, 3> rows_{};
    std::array<std::array<Place, 3>, bvh8_width> corners_;
    std::array<std::uint32_t, bvh8_width> numbers_;
    std::array<Sides, bvh8_width> sides_;
};

}  // namespace raylab
