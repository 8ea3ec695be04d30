#pragma once

#include "raylab/accelerator/octree/octree_walk.h"
#include "raylab/base/large_pages.h"

namespace raylab {

/// A hash table of the tree's cells by their names. The root's name is 1, the children of n are 8 n ... 8 n + 7.
/// (Glassner, Space Subdivision for Fast Ray Tracing, IEEE CG&A 4(10), 1984, has 1 ... 8 as digits.) The eight children
/// of a cell stand side by side in the slot of their parent's name, because a ray looks for one after the other.
class CellNames {
public:
    explicit CellNames(const OctreeCells& tree);
    OctreeCell find(std::uint64_t name) const { return cells_[8 * slot(name >> 3) + (name & 7)]; }
    std::size_t bytes() const {
        return parents_.capacity() * sizeof(std::uint64_t) + cells_.capacity() * sizeof(OctreeCell);
    }

private:
    void name_below(std::uint64_t parent, std::uint32_t first, const OctreeCells& tree);

    // The slot of a parent, or the free one in which it would stand: the search begins where multiplication by 2^64 /
    // golden ratio scatters the name, and goes on slot by slot.
    std::size_t slot(std::uint64_t parent) const {
        std::size_t i = (parent * 0x9e3779b97f4a7c15u) >> shift_;
        while (parents_[i] != parent && parents_[i] != none) i = (i + 1) & (parents_.size() - 1);
        return i;
    }

    static constexpr std::uint64_t none = ~std::uint64_t{0};  // a free slot; 0 is the root's parent
    std::vector<std::uint64_t> parents_;                      // 2^k slots
    LargeVector<OctreeCell> cells_;                           // eight for each slot
    int shift_;                                               // 64 - k
};

/// Finds the leaf of a point from the root down, cell after cell by name: no cell stores where its children are.
class ByName {
public:
    ByName(const CellNames& names, const LatticeRay& ray) : names_(&names), unmirrored_(ray) {}

    FoundLeaf operator()(const LatticeCell& cell, std::uint32_t, std::uint64_t& steps) const {
        std::uint64_t name = 1;
        for (int size = Lattice::bits;; --size) {
            ++steps;
            const OctreeCell found = names_->find(name);
            if (!found.is_divided()) return {found, cell, size};
            name = name << 3 | unmirrored_.place_in_block(cell, size - 1, 1);
        }
    }

private:
    const CellNames* names_;
    Unmirrored unmirrored_;
};

/// Goes from leaf to leaf by a point slightly beyond the exit, whose cell is looked up by name. The octree has only
/// blocks of eight.
class HashTable {
public:
    explicit HashTable(const OctreeCells& tree) : names_(tree) {}
    static OctreeLimits limits() { return {}; }
    std::size_t bytes() const { return names_.bytes(); }

    template <class AtLeaf>
    void walk(const OctreeCells&, const LatticeRay& ray, std::uint64_t& steps, const AtLeaf& at_leaf) const {
        walk_by_points(ray, ByName(names_, ray), steps, at_leaf);
    }

private:
    CellNames names_;
};

}  // namespace raylab
