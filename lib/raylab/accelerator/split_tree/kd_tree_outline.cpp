#include "raylab/accelerator/split_tree/kd_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// A few digits do for a plane that rounding has moved slightly away from 0.
std::string words(const SplitTree::Node& node, const Box& scene) {
    const auto axis = static_cast<int>(node.axis());
    const float plane = node.plane(), size = scene.max[axis] - scene.min[axis];
    const bool is_nearly_zero = plane != 0 && std::abs(plane) < 1e-6f * size;
    return fmt::format("{} = ", "xyz"[axis]) + (is_nearly_zero ? "~0" : fmt::format("{:.4g}", plane));
}

}  // namespace

std::vector<Box> KdTree::cells() const {
    std::vector<Box> cells(tree_.nodes.size());
    if (!cells.empty()) cells[0] = tree_.bounds;
    for (std::size_t i = 0; i < cells.size(); ++i) {  // parents stand before their children
        const SplitTree::Node& node = tree_.nodes[i];
        if (node.is_leaf()) continue;
        const auto axis = static_cast<int>(node.axis());
        cells[node.below()] = cells[node.above()] = cells[i];
        cells[node.below()].max[axis] = cells[node.above()].min[axis] = node.plane();
    }
    return cells;
}

Outline KdTree::outline() const {
    const std::vector<Box> cells = this->cells();
    const std::vector<std::uint32_t> places = bounded_.places();
    Outline outline;
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
        const SplitTree::Node& node = tree_.nodes[i];
        Outline::Node drawn{.bound = cells[i]};
        if (node.is_leaf()) {
            for (const std::uint32_t part : tree_.in(node)) drawn.primitives.push_back(places[part]);
        } else {
            drawn.children = {node.below(), node.above()};
            drawn.label = words(node, tree_.bounds);
        }
        outline.nodes.push_back(std::move(drawn));
    }
    return outline;
}

KdTree::Size KdTree::size() const {
    Size size{.nodes = tree_.nodes.size(), .references = tree_.parts.size()};
    std::vector<std::size_t> depth(size.nodes, 1);
    for (std::size_t i = 0; i < size.nodes; ++i) {
        const SplitTree::Node& node = tree_.nodes[i];
        size.deepest = std::max(size.deepest, depth[i]);
        if (node.is_leaf()) {
            ++size.leaves;
            size.empty_leaves += node.count() == 0;
        } else {
            depth[node.below()] = depth[node.above()] = depth[i] + 1;
        }
    }
    return size;
}

}  // namespace raylab
