#pragma once

#include "raylab/accelerator/octree/lattice_shape.h"

#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// When a cell of an octree becomes a leaf, and when it is cut into more than eight cells at once.
struct OctreeLimits {
    // A cell with no more primitives than this is a leaf. (Of 8, 12, 16 and 20 the fastest for scans: a step costs as
    // much as two or three tests.)
    std::uint32_t few = 16;
    // A cell that many cuts below the root is a leaf; the depth is smaller where there would be too many cells.
    int depth = 14;
    enum class Cut {
        always,  // every other cell is cut
        // A cell is cut where a ray is expected to need fewer tests in its children together, within the budget.
        where_it_pays,
    } cut = Cut::where_it_pays;
    int budget = 64;  // references for each primitive, on average; a cell passes its own on to its children

    enum class Assign {
        by_box,
        by_shape
        // Which shapes a cell refers to: those that touch it, where that can be computed, or those whose box does.
    } assign = Assign::by_shape;

    /// SEADS (spatially enumerated auxiliary data structure): a cell becomes a grid of 2^k cells along each side.
    struct Seads {
        std::uint32_t largest = 0;  // a cell with no more primitives than this becomes a grid; 0: none does
        int bits = 2;               // k
    } seads = {};
};

/// A cell of an octree: a leaf with some of the references, or divided into a block of cells.
struct OctreeCell {
    std::uint32_t first = 0;  // index of the first reference of a leaf, or of the first cell of a block
    // For a leaf the number of references; otherwise divided + k for a block of 2^k cells along each side.
    std::uint32_t rest = 0;

    static constexpr std::uint32_t divided = 1u << 31;
    bool is_divided() const { return rest >= divided; }
    int block_bits() const { return static_cast<int>(rest - divided); }
};

/// An octree over shapes, in numbers of a lattice; the algorithms that find the next cell traverse it. The block of a
/// divided cell of 2^s lattice cells a side has its cells in the order of x + y 2^k + z 4^k. The root fills every place
/// of the first block, so that it is found like any other cell.
struct OctreeCells {
    std::vector<OctreeCell> cells;
    std::vector<std::uint32_t> references;  // indices of shapes, leaf after leaf

    std::span<const std::uint32_t> in(const OctreeCell& leaf) const {
        return std::span(references).subspan(leaf.first, leaf.rest);
    }
};

/// Builds an octree as deep as the limits allow, or as deep as a total of 2^22 cells and references, and 128 more for
/// each shape, allows: a few large shapes could otherwise fill 4^depth cells each.
OctreeCells build_octree(std::span<const LatticeShape> shapes, const OctreeLimits& limits);

/// The place of a lattice cell in a block of 2^bits cells along each side, each 2^size lattice cells wide.
inline std::uint32_t place_in_block(const LatticeCell& cell, int size, int bits) {
    const std::int32_t mask = (1 << bits) - 1;
    const auto along = [&](std::size_t axis) { return static_cast<std::uint32_t>((cell[axis] >> size) & mask); };
    return along(0) | along(1) << bits | along(2) << (2 * bits);
}

/// The lowest lattice cell of the cell at a place in the block that begins at `lowest`.
inline LatticeCell lowest_in_block(LatticeCell lowest, std::uint32_t place, int size, int bits) {
    const std::uint32_t mask = (1u << bits) - 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        lowest[axis] += static_cast<std::int32_t>((place >> (static_cast<int>(axis) * bits)) & mask) << size;
    return lowest;
}

}  // namespace raylab
