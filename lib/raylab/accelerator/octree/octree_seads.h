#pragma once

#include "raylab/accelerator/octree/octree_walk.h"

namespace raylab {

/// Goes from cell to cell of a block by 3D-DDA, as through a small grid, and up and down between blocks. Only the axis
/// along which the next cell's number differs is examined. Blocks of 2 x 2 x 2 cells make an octree, larger ones a
/// SEADS. (Fujimoto, Tanaka and Iwata, ARTS: Accelerated Ray-Tracing System, IEEE CG&A 6(4), 1986.)
class BlockWalk {
public:
    BlockWalk(const OctreeCells& tree, const LatticeRay& ray)
        : cells_(tree.cells.data()), ray_(&ray), unmirrored_(ray), t_(ray.start()) {
        reach_planes();
    }

    template <class AtLeaf>
    void walk(std::uint64_t& steps, const AtLeaf& at_leaf) {
        double end = ray_->end();
        while (t_ <= end) {
            ++steps;
            const OctreeCell found = cells_[block_.first + unmirrored_.place_in_block(cell_, block_.size, block_.bits)];
            if (found.is_divided()) {
                down(found);
                continue;
            }
            // t never decreases; rounding could place the exit before the entry.
            t_ = std::max(t_, std::min({exits_[0], exits_[1], exits_[2]}));
            end = std::min(end, at_leaf(FoundLeaf{found, cell_, block_.size}));
            const std::uint32_t changed = step();
            if (changed >= static_cast<std::uint32_t>(Lattice::side)) return;
            if (changed >> (block_.size + block_.bits) != 0) up(changed);
        }
    }

private:
    struct Block {
        std::uint32_t first;
        int size, bits;  // 2^bits cells along each side, each 2^size lattice cells wide
    };

    void down(const OctreeCell& cell) {
        above_[depth_++] = block_;
        const std::int32_t inside = (1 << block_.size) - 1;
        block_ = {cell.first, block_.size - cell.block_bits(), cell.block_bits()};
        for_each_axis([&](std::size_t axis) {
            cell_[axis] = ray_->cell(axis, t_, cell_[axis], cell_[axis] + inside) & -(1 << block_.size);
        });
        reach_planes();
    }

    void up(std::uint32_t changed) {
        do block_ = above_[--depth_];
        while (changed >> (block_.size + block_.bits) != 0);
        for (std::int32_t& number : cell_) number &= -(1 << block_.size);
        reach_planes();
    }

    void reach_planes() {
        for_each_axis([&](std::size_t axis) { exits_[axis] = ray_->reaches(axis, cell_[axis] + (1 << block_.size)); });
    }

    // Steps to the next cell and returns the bits of its number that change.
    std::uint32_t step() {
        const std::int32_t side = 1 << block_.size;
        std::uint32_t changed = 0;
        for_each_axis([&](std::size_t axis) {
            const std::int32_t next = cell_[axis] + (exits_[axis] <= t_ ? side : 0);
            changed |= static_cast<std::uint32_t>(next ^ cell_[axis]);
            cell_[axis] = next;
        });
        reach_planes();
        return changed;
    }

    const OctreeCell* cells_;
    const LatticeRay* ray_;
    Unmirrored unmirrored_;
    double t_;
    Block block_{0, Lattice::bits, 1};
    LatticeCell cell_{};
    std::array<double, 3> exits_{};
    std::array<Block, Lattice::bits> above_{};
    std::size_t depth_ = 0;
};

/// 3D-DDA through an octree with SEADS in its leaves.
struct Seads {
    explicit Seads(const OctreeCells&) {}
    static OctreeLimits limits() { return {.few = 4, .seads = {.largest = 64, .bits = 2}}; }
    static std::size_t bytes() { return 0; }

    template <class AtLeaf>
    void walk(const OctreeCells& tree, const LatticeRay& ray, std::uint64_t& steps, const AtLeaf& at_leaf) const {
        BlockWalk(tree, ray).walk(steps, at_leaf);
    }
};

}  // namespace raylab
