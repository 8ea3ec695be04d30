#pragma once

#include <array>
#include <functional>
#include <optional>

namespace raylab {

/// What a ray may ask of a binary tree of boxes, whose nodes have numbers; the root's is 0. The box of a node holds all
/// that is below the node, and may overlap any other box.
struct AskedTree {
    /// The t at which the ray enters the box of a node; absent where it misses the box.
    std::function<std::optional<double>(int node)> entry;
    /// The two nodes below a node; absent for a leaf.
    std::function<std::optional<std::array<int, 2>>(int node)> children;
    /// The least t at which the ray hits something in a leaf; absent where it hits nothing there.
    std::function<std::optional<double>(int leaf)> hit;
};

/// The least t at which the ray hits anything in the tree; absent where it hits nothing. Of two children the one that
/// is entered first is opened first, and nothing is opened that is entered beyond the nearest hit so far.
std::optional<double> nearest_in_tree(const AskedTree& tree);

}  // namespace raylab
