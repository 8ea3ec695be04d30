#pragma once

#include "raylab/geometry/box.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

/// A binary tree over boxes. It has a root where there is anything at all, and is at most max_depth nodes deep.
struct BoxTree {
    static constexpr int max_depth = 80;

    /// The six planes of two boxes side by side: the lower one of each axis, then the upper one.
    using Planes = std::array<std::array<float, 2>, 6>;

    /// A node holds its two children's boxes, so that a visit reads one cache line and nothing else.
    struct alignas(64) Node {
        Planes planes;
        std::array<std::uint32_t, 2> first;  // of a leaf: its first place in `order`; else the index of a node
        std::array<std::uint32_t, 2> count;  // of a leaf: how many; else 0
    };

    std::vector<Node> nodes;
    std::vector<std::uint32_t> order;  // the indices of the boxes, leaf after leaf
};

/// Splits where the surface area heuristic, over 16 bins an axis, expects the least work (Wald, On fast Construction of
/// SAH-based Bounding Volume Hierarchies, 2007); in the middle of the order where it sees no difference.
BoxTree build_box_tree(std::span<const Box> boxes);

}  // namespace raylab
