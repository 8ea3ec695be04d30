#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/report/ray_tree/ray_tree_view.h"

// How the parts of a ray tree look in a diagram: kinds differ by colour and by line style, weight by size.

namespace raylab {

enum class Detail {
    full,  // what it met, its weight, what it adds
    word,  // the object; the rest in the tooltip
    dot,   // a mark; all in the tooltip
};

/// As much as can be read in a drawing of so many nodes.
Detail detail_for(std::size_t nodes);

/// A ray that brings this colour; `cut` are the branches below it that were not followed.
DiagramNode look_of_ray(const RayNode& node, const Color& brought, const std::vector<RayNode>& cut, Detail detail);

DiagramNode look_of_feeler(const RayNode& node, Detail detail);
DiagramNode look_of_cut(const RayNode& node);
DiagramNode look_of(const PrunedBranches& branches);

/// The edge to a node from its parent.
DiagramEdge edge_to(const RayNode& node, const RayNode& parent, Detail detail);

/// The same node, red and thick, with a remark.
DiagramNode marked(const RayNode& node, DiagramNode look, const std::string& remark);

}  // namespace raylab
