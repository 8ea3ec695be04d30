#include "raylab/accelerator/bvh8/bvh8_collapse.h"

#include <algorithm>

namespace raylab::bvh8_parts {

CollapsedTree::CollapsedTree(References& references, const ReferenceRange& part, int depth) : references_(references) {
    nodes_.reserve(part.size() / 2);
    grow(part, depth);
}

std::uint32_t CollapsedTree::grow(const ReferenceRange& part, int depth) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.part = part});
    if (!references_.fit_in_leaf(part)) {
        const auto [left, right] = references_.split(part, depth, alone_);
        nodes_[at].left = grow(left, depth + 1);
        nodes_[at].right = grow(right, depth + 1);
    }
    expect_work(nodes_[at]);
    return at;
}

void CollapsedTree::expect_work(Node& node) const {
    const float area = node.part.box.half_area();
    if (node.left == 0) {
        node.work.fill(area * leaf_work);
        return;
    }
    const auto &left = nodes_[node.left].work, &right = nodes_[node.right].work;
    for (std::size_t children = 2; children <= bvh8_width; ++children) {
        node.work[children] = infinity;
        node.of_left[children] = 1;
        for (std::size_t k = 1; k < children; ++k) {
            if (const float work = left[k] + right[children - k]; work < node.work[children]) {
                node.work[children] = work;
                node.of_left[children] = static_cast<std::uint8_t>(k);
            }
        }
    }
    // One child: a node of its own, and its children. More children than pay are not needed.
    node.work[1] = area + node.work[bvh8_width];
    for (std::size_t children = 2; children < bvh8_width; ++children)
        node.work[children] = std::min(node.work[children], node.work[children - 1]);
}

CollapsedTree::Children CollapsedTree::children(std::size_t at) const {
    Children children;
    const Node& node = nodes_[at];
    if (node.left == 0) {
        children.parts[children.count++] = {at, true};
    } else {
        const std::size_t of_left = node.of_left[bvh8_width];
        add_children(node.left, of_left, children);
        add_children(node.right, bvh8_width - of_left, children);
    }
    return children;
}

void CollapsedTree::add_children(std::size_t at, std::size_t most, Children& children) const {
    const Node& node = nodes_[at];
    while (most > 1 && node.work[most] == node.work[most - 1]) --most;
    if (node.left == 0 || most == 1) {
        children.parts[children.count++] = {at, node.left == 0};
        return;
    }
    add_children(node.left, node.of_left[most], children);
    add_children(node.right, most - node.of_left[most], children);
}

}  // namespace raylab::bvh8_parts
