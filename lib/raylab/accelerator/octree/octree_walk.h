#pragma once

#include "raylab/accelerator/octree/octree_cells.h"

// Parts that are shared by the algorithms for the next cell. Each calls at_leaf(FoundLeaf) for the leaves a ray goes
// through, in order; at_leaf returns the t at which the ray ends. Each counts all cells it looks at, leaves and others.
// Cells are numbered along the ray's mirrored axes, so that the numbers grow along all of them.

namespace raylab {

/// A leaf that was found: one lattice cell in it, and its size: it is 2^size lattice cells wide.
struct FoundLeaf {
    OctreeCell cell;
    LatticeCell in;
    int size;
};

/// The place of a cell in a block, with the ray's mirroring undone.
class Unmirrored {
public:
    explicit Unmirrored(const LatticeRay& ray) : x_(ray.mirrored(0)), y_(ray.mirrored(1)), z_(ray.mirrored(2)) {}
    std::uint32_t place_in_block(const LatticeCell& cell, int size, int bits) const {
        return raylab::place_in_block({cell[0] ^ x_, cell[1] ^ y_, cell[2] ^ z_}, size, bits);
    }

private:
    std::int32_t x_, y_, z_;
};

/// Goes from leaf to leaf by a point in the next lattice cell beyond the plane where the ray leaves a leaf:
/// find(lattice cell, bits in which it differs from the last one, steps) returns the leaf of that cell.
template <class Find, class AtLeaf>
void walk_by_points(const LatticeRay& ray, Find find, std::uint64_t& steps, const AtLeaf& at_leaf) {
    LatticeCell cell{};
    double t = ray.start(), end = ray.end();
    if (!(t <= end)) return;
    for_each_axis([&](std::size_t axis) { cell[axis] = ray.cell(axis, t, 0, Lattice::side - 1); });
    std::uint32_t changed = Lattice::side;
    while (true) {
        const FoundLeaf leaf = find(cell, changed, steps);
        LatticeCell beyond{};
        std::array<double, 3> exits{};
        for_each_axis([&](std::size_t axis) {
            beyond[axis] = (cell[axis] | ((1 << leaf.size) - 1)) + 1;
            exits[axis] = ray.reaches(axis, beyond[axis]);
        });
        // t never decreases; rounding could place the exit before the entry.
        t = std::max(t, std::min({exits[0], exits[1], exits[2]}));
        end = std::min(end, at_leaf(leaf));
        if (!(t <= end)) return;
        changed = 0;
        for_each_axis([&](std::size_t axis) {
            const std::int32_t inside = ray.cell(axis, t, cell[axis], beyond[axis] - 1);
            const std::int32_t next = exits[axis] <= t ? beyond[axis] : inside;
            changed |= static_cast<std::uint32_t>(next ^ cell[axis]);
            cell[axis] = next;
        });
        if (changed >= static_cast<std::uint32_t>(Lattice::side)) return;
    }
}

}  // namespace raylab
