#include "raylab/report/ray_tree/ray_tree_view.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace raylab {

namespace {

bool is_ray(const RayNode& node) { return was_cast(node) && node.kind != RayKind::shadow; }

// The throughput for sorting: a tree that was read from a file may contain NaN.
double throughput(const RayNode& node) { return std::isnan(node.throughput) ? 0 : node.throughput; }

// The rays above the threshold, or the heaviest ones. Among equal throughputs the ray that was traced first wins, so
// that the choice is a tree.
std::vector<char> chosen_rays(const RayTree& tree, const RayTreeView& view) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (is_ray(tree.nodes[i]) && (!view.prune || *view.prune <= 0 || tree.nodes[i].throughput > *view.prune))
            order.push_back(i);
    if (!view.prune && order.size() > view.largest) {
        std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return throughput(tree.nodes[i]); });
        order.resize(view.largest);
    }
    std::vector<char> chosen(tree.nodes.size(), 0);
    for (const std::size_t i : order) chosen[i] = 1;
    return chosen;
}

void add_way_to(const RayTree& tree, std::size_t node, std::vector<char>& drawn) {
    for (std::size_t i = node; i != RayNode::none; i = tree.nodes[i].parent) drawn[i] = 1;
}

// The chosen rays whose parents are drawn, with their cut branches and, if wanted, their shadow rays.
std::vector<char> drawn_nodes(const RayTree& tree, const RayTreeView& view) {
    const auto chosen = chosen_rays(tree, view);
    std::vector<char> drawn(tree.nodes.size(), 0);
    if (!drawn.empty()) drawn[0] = 1;
    for (const std::size_t node : view.marked) add_way_to(tree, node, drawn);
    for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
        const auto& node = tree.nodes[i];
        const bool wanted = node.kind == RayKind::shadow ? view.shadow_rays == RayTreeView::ShadowRays::shown
                                                         : chosen[i] || !was_cast(node);
        if (wanted && drawn[node.parent]) drawn[i] = 1;
    }
    return drawn;
}

PrunedBranches& branches_under(std::size_t parent, std::vector<PrunedBranches>& all) {
    const auto found = std::ranges::find(all, parent, &PrunedBranches::parent);
    return found != all.end() ? *found : all.emplace_back(PrunedBranches{parent});
}

std::vector<PrunedBranches> pruned_branches(const RayTree& tree, const std::vector<char>& drawn) {
    std::vector<PrunedBranches> all;
    std::vector<std::size_t> under(tree.nodes.size());  // the nearest ancestor that is drawn
    for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
        const auto& node = tree.nodes[i];
        under[i] = drawn[node.parent] ? node.parent : under[node.parent];
        if (drawn[i] || !is_ray(node)) continue;
        auto& branches = branches_under(under[i], all);
        ++branches.rays;
        if (drawn[node.parent]) branches.throughput += node.throughput;
        branches.contribution += node.contribution;
    }
    return all;
}

// The colour that each ray returns: what it and its descendants add to the pixel, divided by its throughput.
std::vector<Color> brought_colors(const RayTree& tree) {
    std::vector<Color> sums(tree.nodes.size(), Color{0, 0, 0});
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const auto& node = tree.nodes[i];
        if (node.kind != RayKind::shadow) sums[i] += node.contribution;
        if (i > 0 && node.kind != RayKind::shadow) sums[node.parent] += sums[i];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto& node = tree.nodes[i];
        sums[i] = node.kind == RayKind::shadow ? node.local
                  : node.throughput > 0        ? sums[i] / node.throughput
                                               : node.local;
    }
    return sums;
}

}  // namespace

ShownTree shown_tree(const RayTree& tree, const RayTreeView& view) {
    const auto drawn = drawn_nodes(tree, view);
    ShownTree shown{.nodes = {}, .pruned = pruned_branches(tree, drawn), .brought = brought_colors(tree)};
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (drawn[i]) shown.nodes.push_back(i);
    return shown;
}

}  // namespace raylab
