#include "raylab/report/ray_tree/ray_tree_diagram.h"

#include "raylab/report/ray_tree/ray_tree_style.h"

#include <algorithm>
#include <map>

namespace raylab {

namespace {

bool has_diffuse_rays(const RayTree& tree) {
    return std::ranges::count(tree.nodes, RayKind::diffuse, &RayNode::kind) > 0;
}

// Two lines, so that a narrow tree makes a narrow drawing.
std::string legend(Detail detail, const RayTree& tree) {
    const std::string all = std::string("blue, solid: reflected   |   green, dashed: transmitted") +
                            (has_diffuse_rays(tree) ? "   |   orange: diffuse" : "") +
                            "\nfill: the colour the ray brings";
    if (detail == Detail::full) return all + "   |   size: its throughput";
    return all + "   |   size, number: its throughput   |   diamond: it hit nothing";
}

// Draws one tree into a diagram.
class Drawing {
public:
    Drawing(Diagram& diagram, const MarkedTree& drawn, const ShownTree& shown, Detail detail, std::size_t group)
        : diagram_(diagram), drawn_(drawn), nodes_(drawn.tree.nodes), shown_(shown), detail_(detail), group_(group) {}

    void draw() {
        const auto below = children(drawn_.tree);
        for (const std::size_t i : shown_.nodes) add(i, below[i]);
        for (const auto& branches : shown_.pruned) {
            diagram_.edges.push_back({.from = place_.at(branches.parent),
                                      .to = add(style_of(branches)),
                                      .color = "#8a8a8a",
                                      .style = "dotted"});
        }
    }

private:
    std::size_t add(DiagramNode look) {
        look.group = group_;
        diagram_.nodes.push_back(std::move(look));
        return diagram_.nodes.size() - 1;
    }

    // A branch that was cut is listed in its parent's label: it is drawn as a node only where it is marked.
    void add(std::size_t i, const std::vector<std::size_t>& below) {
        const auto& node = nodes_[i];
        const bool is_marked = drawn_.marked == i;
        if (!was_cast(node) && !is_marked) return;
        const DiagramNode look = style_of_node(i, below);
        place_[i] = add(is_marked ? marked(node, look, drawn_.remark) : look);
        if (i == 0) return;
        auto edge = edge_to(node, nodes_[node.parent], detail_);
        edge.from = place_.at(node.parent);
        edge.to = place_[i];
        diagram_.edges.push_back(std::move(edge));
    }

    DiagramNode style_of_node(std::size_t i, const std::vector<std::size_t>& below) const {
        const auto& node = nodes_[i];
        if (node.kind == RayKind::shadow) return style_of_shadow_ray(node, detail_);
        if (!was_cast(node)) return style_of_cut(node);
        std::vector<RayNode> cut;
        for (const std::size_t child : below)
            if (!was_cast(nodes_[child])) cut.push_back(nodes_[child]);
        return style_of_ray(node, shown_.brought[i], cut, detail_);
    }

    Diagram& diagram_;
    const MarkedTree& drawn_;
    const std::vector<RayNode>& nodes_;
    const ShownTree& shown_;
    const Detail detail_;
    const std::size_t group_;
    std::map<std::size_t, std::size_t> place_;  // from a node of the tree to its place in the diagram
};

std::size_t drawn_nodes(const RayTree& tree, const ShownTree& shown) {
    return shown.pruned.size() + static_cast<std::size_t>(std::ranges::count_if(
                                     shown.nodes, [&](std::size_t i) { return was_cast(tree.nodes[i]); }));
}

ShownTree shown_with_mark(const MarkedTree& tree, RayTreeView view) {
    if (tree.marked) view.marked.push_back(*tree.marked);
    return shown_tree(tree.tree, view);
}

}  // namespace

Diagram ray_tree_diagram(const RayTree& tree, const std::string& title, const RayTreeView& view) {
    const MarkedTree drawn{tree, title, {}, {}};
    const auto shown = shown_tree(tree, view);
    const Detail detail = detail_for(drawn_nodes(tree, shown));
    Diagram diagram{.title = title + "\n" + legend(detail, tree), .nodes = {}, .edges = {}};
    // A layered drawing of this many nodes would be wider than any screen.
    if (detail == Detail::dot) diagram.layout = Diagram::Layout::radial;
    Drawing(diagram, drawn, shown, detail, DiagramNode::no_group).draw();
    return diagram;
}

Diagram ray_trees_diagram(const MarkedTree& one, const MarkedTree& other, const std::string& title,
                          const RayTreeView& view) {
    const auto shown_one = shown_with_mark(one, view), shown_other = shown_with_mark(other, view);
    const Detail detail = detail_for(drawn_nodes(one.tree, shown_one) + drawn_nodes(other.tree, shown_other));
    Diagram diagram{
        .title = title + "\n" + legend(detail, one.tree), .nodes = {}, .edges = {}, .groups = {one.title, other.title}};
    Drawing(diagram, one, shown_one, detail, 0).draw();
    Drawing(diagram, other, shown_other, detail, 1).draw();
    return diagram;
}

}  // namespace raylab
