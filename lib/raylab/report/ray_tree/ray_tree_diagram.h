#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/report/ray_tree/ray_tree_view.h"

namespace raylab {

/// A ray tree as a diagram: blue and solid what is reflected, green and dashed what is transmitted, grey the shadow
/// feelers; filled with the colour that a ray brings; the heavier, the larger. Up to 15 nodes say what they met; more
/// say it in a word, and everything in their tooltips.
Diagram ray_tree_diagram(const RayTree& tree, const std::string& title, const RayTreeView& view = {});

/// A tree beside another, with one node of each marked red, thick and with a remark.
struct MarkedTree {
    const RayTree& tree;
    std::string title;
    std::optional<std::size_t> marked;
    std::string remark;
};

/// Both trees in frames of their own.
Diagram ray_trees_diagram(const MarkedTree& one, const MarkedTree& other, const std::string& title,
                          const RayTreeView& view = {});

}  // namespace raylab
