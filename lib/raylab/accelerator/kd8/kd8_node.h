#pragma once

#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/accelerator/split_tree/split_tree.h"
#include "raylab/base/large_pages.h"
#include "raylab/geometry/bounds/box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

/// What lies in a cell: eight smaller cells, a leaf of triangles as bvh8 has them, a list of leaves, or nothing.
///
/// Two of its bits belong to the plane that has the same place in a node: they are the axis that the plane stands
/// across, by which walks permute a ray's numbers, and instructions for that read no other bits.
class Kd8Child {
public:
    Kd8Child() = default;
    static Kd8Child node(std::size_t index) { return Kd8Child(index << axis_bits); }
    static Kd8Child leaf(Bvh8Child leaf) { return Kd8Child(leaf_bit | place_of(leaf) << axis_bits); }
    static Kd8Child list(std::size_t first) { return Kd8Child(leaf_bit | list_bit | first << axis_bits); }
    static Kd8Child none() { return Kd8Child(~std::uint32_t{axis_mask}); }
    static constexpr std::size_t max_places = std::size_t{1} << 28;  // of nodes, of lists, and eight for each line

    Kd8Child across(std::size_t axis) const { return Kd8Child((bits_ & ~axis_mask) | axis); }
    std::size_t axis() const { return bits_ & axis_mask; }

    bool is_node() const { return (bits_ & leaf_bit) == 0; }
    bool is_list() const { return (bits_ & list_bit) != 0; }  // of what is not a node
    bool is_none() const { return bits_ >= none().bits_; }
    /// Of a node: where it begins, in bytes after the first one.
    std::size_t node_offset() const { return std::size_t{bits_ & ~axis_mask} * (64 >> axis_bits); }
    std::size_t first() const { return (bits_ & place_mask) >> axis_bits; }  // an index of nodes or of lists
    Bvh8Child leaf() const {
        return Bvh8Child::leaf(Bvh8Child::Kind::triangles, first() / bvh8_width, first() % bvh8_width + 1);
    }

private:
    template <class Bits>
    explicit Kd8Child(Bits bits) : bits_(static_cast<std::uint32_t>(bits)) {}
    static std::size_t place_of(Bvh8Child leaf) { return bvh8_width * leaf.first() + leaf.count() - 1; }

    static constexpr int axis_bits = 2;
    static constexpr std::uint32_t leaf_bit = 1u << 31, list_bit = 1u << 30, axis_mask = (1u << axis_bits) - 1,
                                   place_mask = list_bit - 1 - axis_mask;
    std::uint32_t bits_;  // has no initial value, so that a stack of cells is not cleared first
};

/// Three levels of a kd-tree, in one cache line: up to seven planes that part a cell into eight.
///
/// The first four planes are those that the lower four cells lie between: the one that parts the whole, the one that
/// parts its lower half, and those that part the two halves of that; the last four are those of the upper cells, so the
/// first plane stands here twice. Where a half is not parted any more, its own plane is repeated, and of the cells that
/// this would make, the ones behind it are nothing.
struct alignas(64) Kd8Node {
    std::array<float, bvh8_width> planes;
    std::array<Kd8Child, bvh8_width> children;

    /// Which of the planes parts two cells of which this is one, at a level: 0 for all, 2 for neighbours.
    static constexpr std::size_t plane_between(std::size_t cell, int level) {
        const std::size_t half = cell & 4;
        return level == 0 ? half : level == 1 ? half + 1 : half + 2 + cell / 2 % 2;
    }
    /// Whether the cell lies above that plane.
    static constexpr bool is_above(std::size_t cell, int level) { return (cell >> (2 - level) & 1) != 0; }
};

static_assert(sizeof(Kd8Node) == 64, "Kd8Child::node_offset()");

/// The cells of a kd-tree.
struct Kd8Cells {
    // For one ray: at each three levels seven cells wait, beside the one that is visited.
    static constexpr std::size_t max_waiting = (SplitTree::max_depth / 3 + 1) * (bvh8_width - 1) + 1;

    Box bounds;
    Kd8Child root = Kd8Child::none();
    LargeVector<Kd8Node> nodes;
    std::vector<Bvh8Child> lists;  // each ends with Bvh8Child::none()

    std::span<const Bvh8Child> leaves_of(Kd8Child list) const {
        const Bvh8Child* const first = &lists[list.first()];
        const Bvh8Child* last = first;
        while (!last->is_none()) ++last;
        return {first, last};
    }

    std::size_t bytes() const { return nodes.capacity() * sizeof(Kd8Node) + lists.capacity() * sizeof(Bvh8Child); }
};

}  // namespace raylab
