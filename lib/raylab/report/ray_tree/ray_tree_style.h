#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/report/ray_tree/ray_tree_view.h"

// The look of a ray tree's parts in a diagram: kinds differ in colour and line style, throughputs in size.

namespace raylab {

enum class Detail {
    full,  // what was hit, the throughput, and the contribution
    word,  // the object and the throughput, where they fit; the rest is in the tooltip
    dot,   // the same in smaller nodes
};

/// The most detail that is readable in a drawing of this many nodes.
Detail detail_for(std::size_t nodes);

/// The colour of a kind of rays, and Graphviz' name of its dashes.
struct RayStrokes {
    const char *color, *style;
};
RayStrokes strokes_of(RayKind kind);

/// The look of a ray that returns this colour; `cut` has the branches below it that were not followed.
DiagramNode style_of_ray(const RayNode& node, const Color& brought, const std::vector<RayNode>& cut, Detail detail);

DiagramNode style_of_shadow_ray(const RayNode& node, Detail detail);
DiagramNode style_of_cut(const RayNode& node);
DiagramNode style_of(const PrunedBranches& branches);

/// The edge to a node from its parent.
DiagramEdge edge_to(const RayNode& node, const RayNode& parent, Detail detail);

/// Makes a node's look red and thick, with a remark.
DiagramNode marked(const RayNode& node, DiagramNode look, const std::string& remark);

}  // namespace raylab
