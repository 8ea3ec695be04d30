#pragma once

#include "raylab/accelerator/bvh/box_split.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

/// A binary tree over boxes. It has a root unless there are no boxes, and is at most max_depth nodes deep.
struct BoxTree {
    static constexpr int max_depth = 80;
    // From this depth on parts are halved: that splits 2^32 boxes in 32 steps.
    static constexpr int halving_depth = max_depth - 33;

    /// The six planes of two boxes side by side: of each axis the lower one, then of each axis the upper one.
    using Planes = std::array<std::array<float, 2>, 6>;

    /// A node holds the boxes of its two children, so that a visit reads one cache line and nothing else. Over a single
    /// box the second child repeats the first, with an empty box.
    struct alignas(64) Node {
        Planes planes;
        std::array<std::uint32_t, 2> first;  // of a leaf: its first place in `order`; of a node: its index
        std::array<std::uint32_t, 2> count;  // of a leaf: the number of boxes in it; of a node: 0

        /// Sets one of the children; its size is the number of boxes of a leaf, or 0 for a node.
        void hold(std::size_t side, const Box& box, std::size_t first_place, std::size_t size);
    };

    std::vector<Node> nodes;
    std::vector<std::uint32_t> order;  // the indices of the boxes, leaf after leaf
};

/// The box of one child.
Box box_of(const BoxTree::Planes& planes, std::size_t side);

/// The cost of visiting a node, in primitive tests: testing both its boxes takes about half as long as testing a
/// triangle.
inline constexpr double box_visit_cost = 0.5;

struct BoxTreeOptions {
    SplitRule rule = SplitRule::binned;
    std::size_t largest_leaf = 8;
};

/// Splits by the rule, or in the middle of the order where all centers are the same. A part becomes a leaf where it is
/// small enough and a split would not lower the cost.
BoxTree build_box_tree(std::span<const Box> boxes, const BoxTreeOptions& options = {});

}  // namespace raylab
