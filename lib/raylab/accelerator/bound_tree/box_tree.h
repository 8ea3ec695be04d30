#pragma once

#include "raylab/accelerator/bound_tree/box_split.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

/// A binary tree over boxes. It has a root where there is anything at all, and is at most max_depth nodes deep.
struct BoxTree {
    static constexpr int max_depth = 80;
    static constexpr int halving_depth = max_depth - 33;  // from here on parts are halved: 2^32 of them in 32 steps

    /// The six planes of two boxes side by side: the lower one of each axis, then the upper one.
    using Planes = std::array<std::array<float, 2>, 6>;

    /// A node holds its two children's boxes, so that a visit reads one cache line and nothing else. Over a single box the
    /// second child repeats the first, with an empty box.
    struct alignas(64) Node {
        Planes planes;
        std::array<std::uint32_t, 2> first;  // of a leaf: its first place in `order`; else the index of a node
        std::array<std::uint32_t, 2> count;  // of a leaf: how many; else 0

        /// Sets one of the children: count 0, or the size of a leaf.
        void hold(std::size_t side, const Box& box, std::size_t first_place, std::size_t size);
    };

    std::vector<Node> nodes;
    std::vector<std::uint32_t> order;  // the indices of the boxes, leaf after leaf
};

/// One child's box.
Box box_of(const BoxTree::Planes& planes, std::size_t side);

/// What a visit of a node costs in primitive tests: both its boxes take about half as long as a triangle.
inline constexpr double box_visit_cost = 0.5;

struct BoxTreeOptions {
    SplitRule rule = SplitRule::binned;
    std::size_t largest_leaf = 8;
};

/// Splits where the rule says, in the middle of the order where it sees no difference. A leaf is what is small enough and not
/// worth splitting.
BoxTree build_box_tree(std::span<const Box> boxes, const BoxTreeOptions& options = {});

}  // namespace raylab
