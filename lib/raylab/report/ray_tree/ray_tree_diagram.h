#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/report/ray_tree/ray_tree_view.h"

namespace raylab {

/// A ray tree as a diagram: reflected rays are blue and solid, transmitted rays green and dashed, shadow rays grey. A
/// node is filled with the colour that its ray returns, and its size grows with its throughput. In a diagram of up to
/// 15 nodes each is labelled with what it hit; with more it has a word, and the details in its tooltip.
Diagram ray_tree_diagram(const RayTree& tree, const std::string& title, const RayTreeView& view = {});

/// A tree to be drawn beside another, with at most one node drawn thick and red, with a remark.
struct MarkedTree {
    const RayTree& tree;
    std::string title;
    std::optional<std::size_t> marked;
    std::string remark;
};

/// Draws both trees, each in its own frame.
Diagram ray_trees_diagram(const MarkedTree& one, const MarkedTree& other, const std::string& title,
                          const RayTreeView& view = {});

}  // namespace raylab
