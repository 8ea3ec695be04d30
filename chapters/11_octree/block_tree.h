#pragma once

#include "raylab/report/plane/plane_drawing.h"

#include <array>
#include <string>
#include <vector>

// An octree's little sister, for drawings on paper: a square that is cut into blocks of square cells.

namespace raylab::octrees {

/// A square cell whose sides are whole numbers: a leaf, or cut into a block of 2^bits cells a side.
struct BlockTree {
    int x, y, side;
    int bits = 0;  // 0: a leaf
    std::vector<BlockTree> cells = {};
};

/// Cuts a square of this side wherever there is a thing, depth after depth: bits[0] is for the root's block.
BlockTree block_tree(int side, const std::vector<PlanePoint>& things, const std::vector<int>& bits);

/// A leaf on a ray's way, and the cells about it from the root on.
struct LeafOnWay {
    std::vector<const BlockTree*> path;  // the root first, the leaf last
    PlanePoint in, out;                  // where the ray enters and leaves it
    int across = 0;                      // the axis of the face by which it leaves: 0 x, 1 y

    const BlockTree& leaf() const { return *path.back(); }
};

/// The leaves along a ray that begins inside the square and goes to the right and up.
std::vector<LeafOnWay> way_through(const BlockTree& tree, PlanePoint from, PlanePoint direction);

/// How many cells, from the root on, two leaves share.
std::size_t shared(const LeafOnWay& a, const LeafOnWay& b);

}  // namespace raylab::octrees
