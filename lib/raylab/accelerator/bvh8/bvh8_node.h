#pragma once

#include "raylab/accelerator/bvh8/bvh8_vertices.h"
#include "raylab/base/large_pages.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/number/scalar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace raylab {

/// A child of a node: another node, or a leaf of one to eight triangles or other primitives.
///
/// Its bits name a place in units of eight bytes: a node's, of 28 units; a leaf's first line, of eight units, whose
/// number of triangles less one is where the place has three zeros; or eight times an index of other primitives. (Walks
/// wait for this place at every step, and instructions multiply by eight themselves.)
class Bvh8Child {
    static constexpr std::uint32_t unit_bytes = 8, node_units = 28, leaf_units = 8;

public:
    enum class Kind : std::uint32_t { node, triangles, others };

    Bvh8Child() = default;
    static Bvh8Child node(std::size_t index) { return Bvh8Child(static_cast<std::uint32_t>(node_units * index)); }
    static Bvh8Child leaf(Kind kind, std::size_t first, std::size_t count) {
        return Bvh8Child(leaf_bit | (kind == Kind::others ? others_bit : 0) |
                         static_cast<std::uint32_t>(leaf_units * first + count - 1));
    }
    static constexpr std::size_t max_primitives = std::size_t{1} << 27, max_lines = max_primitives,
                                 max_nodes = (std::size_t{1} << 31) / node_units;

    bool is_node() const { return (bits_ & leaf_bit) == 0; }
    Kind kind() const {
        if (is_node()) return Kind::node;
        return (bits_ & others_bit) ? Kind::others : Kind::triangles;
    }
    /// An index of nodes, of lines, or of others.
    std::size_t first() const { return is_node() ? bits_ / node_units : low_bits() / leaf_units; }
    std::size_t count() const { return bits_ % leaf_units + 1; }
    /// Of a node: where it begins, in bytes after the first one.
    std::size_t node_offset() const { return std::size_t{bits_} * unit_bytes; }
    /// Of a leaf of triangles: where its first line begins, in bytes after the first of all.
    std::size_t line_offset() const { return std::size_t{bits_ & (others_bit - leaf_units)} * unit_bytes; }
    /// Of a node or a leaf of triangles: a place in its first line, in bytes after the first one of its kind.
    std::size_t offset() const { return low_bits() * unit_bytes; }

    /// By the upper two bits of a child, the address to which all its bits are added as units. (They are looked up,
    /// because GCC makes a branch of "a node or a leaf?", which alternate unpredictably; and no bits are masked, which
    /// would take three instructions for each child that a ray hits.)
    using Addresses = std::array<std::uintptr_t, 4>;
    static Addresses addresses(const void* nodes, const void* lines) {
        const auto before = [](const void* first, std::uint32_t bits) {
            return reinterpret_cast<std::uintptr_t>(first) - std::uintptr_t{bits} * unit_bytes;
        };
        return {before(nodes, 0), before(nodes, 0), before(lines, leaf_bit), before(lines, leaf_bit | others_bit)};
    }
    /// The address of offset(). Of a leaf of others it is none.
    std::uintptr_t address(const Addresses& of) const { return of[bits_ >> 30] + std::uintptr_t{bits_} * unit_bytes; }

    /// Where there is no child: the root is nobody's.
    bool is_root() const { return bits_ == 0; }

    /// No child, which is not a node: where a walk ends. (A leaf of others has one of them, never eight.)
    static Bvh8Child none() { return Bvh8Child(~std::uint32_t{0}); }
    bool is_none() const { return bits_ == none().bits_; }

    /// The same child where so many nodes, lines and others stand before those that it names.
    Bvh8Child after(std::size_t nodes, std::size_t lines, std::size_t others) const {
        const std::size_t before =
            is_node() ? node_units * nodes : leaf_units * (kind() == Kind::others ? others : lines);
        return Bvh8Child(bits_ + static_cast<std::uint32_t>(before));
    }

private:
    explicit Bvh8Child(std::uint32_t bits) : bits_(bits) {}
    std::size_t low_bits() const { return bits_ & (others_bit - 1); }

    static constexpr std::uint32_t leaf_bit = 1u << 31, others_bit = 1u << 30;
    std::uint32_t bits_;  // has no initial value, so that a stack of children is not cleared first
};

/// Eight boxes side by side: the lower planes of each axis, then the upper ones. A place without a child has a box that
/// no ray hits. Coordinates are at most Bvh8Nodes::largest or infinite.
struct alignas(32) Bvh8Node {
    std::array<std::array<float, bvh8_width>, 6> planes;
    std::array<Bvh8Child, bvh8_width> children;

    Bvh8Node() {}  // sets nothing: several threads fill what one of them has made room for

    static Bvh8Node without_children() {
        Bvh8Node node;
        node.children.fill(Bvh8Child::node(0));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.planes[axis].fill(std::numeric_limits<float>::infinity());
            node.planes[axis + 3].fill(-std::numeric_limits<float>::infinity());
        }
        return node;
    }
};

static_assert(sizeof(Bvh8Node) == 28 * 8 && sizeof(Bvh8Line) == 8 * 8, "the units of Bvh8Child");

/// A tree of wide nodes, the root first, and the contents of its leaves.
struct Bvh8Nodes {
    static constexpr int max_depth = 128;
    static constexpr std::size_t max_waiting = max_depth * (bvh8_width - 1) + 1;  // for one ray
    static constexpr float largest = 0x1p60f;                                     // the largest finite plane of a box
    // The farthest coordinate of boxes, corners and origins for which floats are used.
    static constexpr float farthest = 0x1p39f;

    LargeVector<Bvh8Node> nodes;
    LargeVector<Bvh8Line> leaves;      // leaf after leaf of triangles
    float reach = 0;                   // the largest coordinate of a box
    float farthest_origin = farthest;  // of a ray for which floats are used; negative where some box is too far
    // Of a box that encloses the corners of all triangles; the fourth is not used.
    alignas(16) std::array<float, 4> center{}, half_size{};
    std::size_t triangle_count = 0;
    // The other primitives of the leaves: places in the order in which they were given. Empty: each is at its own
    // place.
    std::vector<std::uint32_t> others;

    /// Says what boxes hold the corners of all triangles, and everything.
    void enclose(const Box& corners, const Box& all) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            center[i] = corners.min[axis] / 2 + corners.max[axis] / 2;
            half_size[i] =
                std::max(corners.max[axis] - center[i], center[i] - corners.min[axis]) * (1 + 4 * unit_roundoff<float>);
            if (!all.is_empty()) reach = std::max({reach, std::abs(all.min[axis]), std::abs(all.max[axis])});
        }
        if (reach > farthest) farthest_origin = -1;
    }

    Bvh8Vertices vertices(Bvh8Child leaf) const {
        const auto* first_line = reinterpret_cast<const std::byte*>(leaves.data());
        return Bvh8Vertices(reinterpret_cast<const float*>(first_line + leaf.line_offset()));
    }
    Triangle triangle(Bvh8Child leaf, std::size_t place) const { return vertices(leaf).triangle(place); }
    Sides sides(Bvh8Child leaf, std::size_t place) const { return vertices(leaf).sides(place); }

    /// The number of the triangle at a place of a leaf, in the order in which they were given.
    std::uint32_t number(Bvh8Child leaf, std::size_t place) const { return vertices(leaf).number(place); }

    /// The place of a leaf's i-th other primitive. (Of very many, each place that is read would be waited for.)
    std::size_t other(std::size_t i) const { return others.empty() ? i : others[i]; }

    /// What is reserved beyond (of large trees) is never touched, so that the system gives no memory for it.
    std::size_t bytes() const {
        return nodes.size() * sizeof(Bvh8Node) + leaves.size() * sizeof(Bvh8Line) +
               others.capacity() * sizeof(std::uint32_t);
    }
};

}  // namespace raylab
