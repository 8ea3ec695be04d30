#pragma once

#include "raylab/geometry/shapes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace raylab {

/// The number of boxes, and of triangles, that are tested at once.
inline constexpr std::size_t bvh8_width = 8;

/// A cache line; every leaf begins with one.
struct alignas(64) Bvh8Line {
    std::array<float, 16> floats;

    Bvh8Line() {}  // sets nothing: see Bvh8Node
};

/// The triangles of a leaf as they lie in memory. Triangles that share vertices store them once, so a leaf of eight has
/// about nine vertices: half the bytes of eight times three corners, and half the work of transforming them for a ray.
///
/// First come the vertices of each triangle's corners, eight numbers of sixteen bits; then the number of vertices, at
/// least eight (missing ones are zero); their x, their y, their z; and the triangles' numbers. Vertices are read in two
/// blocks, the first eight and the last eight, which may overlap, and a third between them where there are more than
/// sixteen; a corner names a lane of those blocks, in five bits. The sixteenth bit says that the triangle is seen from
/// its front alone, as the opaque ones of NFF are.
class Bvh8Vertices {
public:
    static constexpr std::size_t largest = 3 * bvh8_width;
    static constexpr std::size_t header = 5;  // counted in floats, as are the sizes below
    static constexpr int lane_bits = 5;
    static constexpr std::uint32_t lane_mask = (1u << lane_bits) - 1;
    static constexpr std::uint32_t front_only = 1u << (3 * lane_bits);

    explicit Bvh8Vertices(const float* start) : start_(start) {}

    const void* all_corners() const { return start_; }
    std::size_t count() const { return std::bit_cast<std::uint32_t>(start_[header - 1]); }
    const float* row(std::size_t axis) const { return start_ + header + axis * count(); }

    static std::size_t block_begin(std::size_t block, std::size_t count) {
        return std::array{std::size_t{0}, count - bvh8_width, bvh8_width}[block];
    }
    static std::size_t lane(std::size_t vertex, std::size_t count) {
        const std::size_t of_last =
            vertex + bvh8_width >= count ? vertex + 2 * bvh8_width - count : vertex + bvh8_width;
        return vertex < bvh8_width ? vertex : of_last;
    }
    // The inverse: the vertex of a lane of the second or the third block. (There is no branch, because it would often
    // be mispredicted.)
    static std::size_t vertex(std::size_t lane, std::size_t count) {
        const std::size_t block = lane / bvh8_width;
        return lane + block % 2 * (count - 2 * bvh8_width) - block / 2 * bvh8_width;
    }
    static std::size_t lines(std::size_t count, std::size_t triangles) {
        return (header + 3 * count + triangles + 15) / 16;
    }

    /// The vertices at a triangle's corners.
    [[gnu::always_inline]] std::array<std::size_t, 3> corners(std::size_t place) const {
        const std::uint32_t names = word(place);
        const auto at = [&](int which) { return vertex(names >> (lane_bits * which) & lane_mask, count()); };
        return {at(0), at(1), at(2)};
    }

    Sides sides(std::size_t place) const { return (word(place) & front_only) != 0 ? Sides::front : Sides::both; }

    Triangle triangle(std::size_t place) const {
        const auto at = [&](std::size_t vertex) {
            const float* x = row(0) + vertex;
            return Vec3f(x[0], x[count()], x[2 * count()]);
        };
        const auto [a, b, c] = corners(place);
        return {at(a), at(b), at(c)};
    }

    /// The number of the triangle at a place, in the order in which they were given.
    std::uint32_t number(std::size_t place) const { return std::bit_cast<std::uint32_t>(numbers()[place]); }
    /// Where the bits of the triangles' numbers begin: behind the rows, of which each has eight floats at least.
    const float* numbers() const { return row(3); }

    /// The lanes of a triangle's corners, and above them what it is seen from.
    std::uint32_t word(std::size_t place) const {
        std::uint16_t word;
        std::memcpy(&word, static_cast<const std::byte*>(all_corners()) + place * sizeof word, sizeof word);
        return word;
    }

private:
    const float* start_;
};

}  // namespace raylab
