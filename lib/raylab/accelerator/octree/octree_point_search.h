#pragma once

#include "raylab/accelerator/octree/octree_walk.h"

namespace raylab {

/// Finds the leaf of a point: up from the last leaf to the smallest cell that holds both, and down again, as lectures
/// teach it. How far up is told by the bits in which the numbers of the two cells differ (Laine and Karras, Efficient
/// Sparse Voxel Octrees, I3D 2010).
class UpAndDown {
public:
    UpAndDown(const OctreeCells& tree, const LatticeRay& ray) : cells_(tree.cells.data()), unmirrored_(ray) {}

    /// `changed` has the bits in which the cell's numbers differ from those of the last one.
    FoundLeaf operator()(const LatticeCell& cell, std::uint32_t changed, std::uint64_t& steps) {
        int size = std::max(size_, static_cast<int>(std::bit_width(changed)) - 1);
        std::uint32_t block = block_[static_cast<std::size_t>(size)];
        while (true) {
            ++steps;
            const OctreeCell found = cells_[block + unmirrored_.place_in_block(cell, size, 1)];
            if (!found.is_divided()) {
                size_ = size;
                return {found, cell, size};
            }
            block = found.first;
            block_[static_cast<std::size_t>(--size)] = block;
        }
    }

private:
    const OctreeCell* cells_;
    Unmirrored unmirrored_;
    std::array<std::uint32_t, Lattice::bits + 1>
        block_{};  // the blocks on the way down to the last leaf, by the size of their cells
    int size_ = Lattice::bits;
};

/// Goes from leaf to leaf by a point slightly beyond the exit, and a search up and down.
struct PointSearch {
    explicit PointSearch(const OctreeCells&) {}
    static OctreeLimits limits() { return {}; }
    static std::size_t bytes() { return 0; }

    template <class AtLeaf>
    void walk(const OctreeCells& tree, const LatticeRay& ray, std::uint64_t& steps, const AtLeaf& at_leaf) const {
        walk_by_points(ray, UpAndDown(tree, ray), steps, at_leaf);
    }
};

}  // namespace raylab
