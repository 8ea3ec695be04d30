#pragma once

#include "raylab/base/large_pages.h"
#include "raylab/geometry/shapes.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace raylab {

/// How many boxes, and how many triangles, are tested at once.
inline constexpr std::size_t wide = 8;

/// What hangs below a place of a node: a node, or a leaf of one to eight triangles or other primitives.
class WideChild {
public:
    enum class Kind : std::uint32_t { node, triangles, others };

    WideChild() = default;
    static WideChild node(std::size_t index) { return WideChild(static_cast<std::uint32_t>(index)); }
    static WideChild leaf(Kind kind, std::size_t first, std::size_t count) {
        return WideChild(leaf_bit | (kind == Kind::others ? others_bit : 0) |
                         static_cast<std::uint32_t>(count - 1) << count_shift | static_cast<std::uint32_t>(first));
    }
    static constexpr std::size_t most_primitives = std::size_t{1} << 27;

    bool is_node() const { return (bits_ & leaf_bit) == 0; }
    Kind kind() const {
        if (is_node()) return Kind::node;
        return (bits_ & others_bit) ? Kind::others : Kind::triangles;
    }
    std::size_t first() const { return bits_ & (most_primitives - 1); }  // the node's index, or the leaf's first place
    std::size_t count() const { return (bits_ >> count_shift & (wide - 1)) + 1; }

private:
    explicit WideChild(std::uint32_t bits) : bits_(bits) {}
    static constexpr std::uint32_t leaf_bit = 1u << 31, others_bit = 1u << 30;
    static constexpr int count_shift = 27;
    std::uint32_t bits_;  // a stack of children is not cleared first
};

/// Eight boxes side by side: the lower planes of each axis, then the upper ones. A place without a child has a box that
/// no ray meets. Coordinates are at most WideNodes::largest or infinite.
struct alignas(32) WideNode {
    std::array<std::array<float, wide>, 6> planes;
    std::array<WideChild, wide> children{};

    WideNode() {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            planes[axis].fill(std::numeric_limits<float>::infinity());
            planes[axis + 3].fill(-std::numeric_limits<float>::infinity());
        }
    }
};

/// A tree of such nodes, the root first, and what its leaves hold.
struct WideNodes {
    static constexpr int max_depth = 64;
    static constexpr float largest = 0x1p60f;   // of a box's finite planes
    static constexpr float farthest = 0x1p39f;  // of corners and origins, for triangles to be tested in floats

    LargeVector<WideNode> nodes;
    /// Leaf after leaf ten rows (a.x, a.y, a.z, b.x, ... c.z, the triangles' numbers) of as many floats as it has
    /// triangles: nothing is padded but the very end, where eight floats may be read past the last.
    LargeVector<float> leaves;
    static constexpr std::size_t leaf_rows = 10;
    bool is_far = false;  // some corner is farther than that
    alignas(16) std::array<float, 4> least_corner{},
        largest_corner{};                  // the box about all of them; the fourth means nothing
    std::size_t triangle_count = 0;
    std::vector<std::uint32_t> others;  // which of them stands where: places in the order they were given

    const float* rows(WideChild leaf) const { return leaves.data() + leaf_rows * leaf.first(); }

    /// Which triangle is at a place of a leaf, in the order they were given: beside its corners, where memory has brought
    /// it with them.
    std::uint32_t number(WideChild leaf, std::size_t place) const {
        return std::bit_cast<std::uint32_t>(rows(leaf)[9 * leaf.count() + place]) - normal;
    }
    static float as_float(std::uint32_t number) { return std::bit_cast<float>(number + normal); }

    /// The triangle at a place of a leaf.
    Triangle triangle(WideChild leaf, std::size_t place) const {
        const float* row = rows(leaf) + place;
        const std::size_t count = leaf.count();
        const auto corner = [&](std::size_t vertex) {
            return Vec3f(row[3 * vertex * count], row[(3 * vertex + 1) * count], row[(3 * vertex + 2) * count]);
        };
        return {corner(0), corner(1), corner(2)};
    }

    std::size_t bytes() const {
        return nodes.capacity() * sizeof(WideNode) + leaves.capacity() * sizeof(float) +
               others.capacity() * sizeof(std::uint32_t);
    }

private:
    // The bits of 2^-31 and up for numbers below 2^27: read with the row before, subnormal floats would be slow.
    static constexpr std::uint32_t normal = 0x30000000;
};

}  // namespace raylab
