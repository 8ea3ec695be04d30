#pragma once

#include "raylab/accelerator/octree/lattice_shape.h"

#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// When a cell of an octree stays whole, and when it is cut into more than eight at once.
struct OctreeLimits {
    std::uint32_t few = 8;  // a cell with no more primitives than this is a leaf
    int depth = 14;         // and one cut so often out of the whole; less often where cells would become too many
    enum class Cut {
        always,         // all others are cut
        where_it_pays,  // those whose children would together be expected to cost a ray fewer tests, within the budget
    } cut = Cut::where_it_pays;
    int budget = 64;  // references for each primitive, on the average; a cell hands its own on to what it is cut into

    enum class Assign {
        by_box,
        by_shape
    } assign = Assign::by_shape;  // what falls into a cell: what touches it, if it can be said

    /// A SEADS (spatially enumerated auxiliary data structure): a cell becomes a grid of 2^k cells a side.
    struct Seads {
        std::uint32_t most = 0;  // once it has no more primitives than this; 0: never
        int bits = 2;            // k
    } seads = {};
};

/// A cell of an octree: a leaf with some of the references, or divided into a block of cells.
struct OctreeCell {
    std::uint32_t first = 0;  // reference, or cell
    std::uint32_t rest = 0;   // of a leaf: how many references; else divided + k for a block of 2^k cells a side

    static constexpr std::uint32_t divided = 1u << 31;
    bool is_divided() const { return rest >= divided; }
    int block_bits() const { return static_cast<int>(rest - divided); }
};

/// An octree over shapes, in numbers of a lattice: what the ways to the next cell walk through. A cell of 2^s lattice
/// cells a side that is divided has its block's cells in the order of x + y 2^k + z 4^k. The root stands at every place
/// of the first block, so that it is found like any other cell.
struct OctreeCells {
    std::vector<OctreeCell> cells;
    std::vector<std::uint32_t> references;  // indices of shapes, leaf after leaf
};

/// As deep as the limits say, or as deep as 2^22 cells and references, and 128 more for each shape, allow: a few large shapes
/// could otherwise fill 4^depth cells each.
OctreeCells build_octree(std::span<const LatticeShape> shapes, const OctreeLimits& limits);

/// Where in a block of 2^bits cells a side, each of 2^size lattice cells, a lattice cell lies.
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
