#include "raylab/accelerator/bvh/moving_boxes.h"

#include <algorithm>

namespace raylab {

namespace {

// Fits the boxes of a tree anew about the primitives of its leaves, where they stand at a time.
class BoxesAt {
public:
    BoxesAt(BoxTree& tree, const Primitives& ordered, float time) : tree_(tree), ordered_(ordered), time_(time) {}

    Box fit(std::size_t node) {
        const Box first = fit(node, 0);
        return tree_.order.size() == 1 ? first : unite(first, fit(node, 1));  // the second child is empty
    }

private:
    Box fit(std::size_t node, std::size_t side) {
        const std::size_t first = tree_.nodes[node].first[side], count = tree_.nodes[node].count[side];
        Box box;
        if (count == 0) box = fit(first);
        for (std::size_t i = first; i < first + count; ++i) box = unite(box, *ordered_.bounds_at(i, time_));
        tree_.nodes[node].hold(side, box, first, count);
        return box;
    }

    BoxTree& tree_;
    const Primitives& ordered_;
    float time_;
};

BoxTree fitted_at(BoxTree tree, const Primitives& ordered, float time) {
    if (!tree.nodes.empty()) BoxesAt(tree, ordered, time).fit(0);
    return tree;
}

}  // namespace

std::vector<MovingBoxBounds::Node> MovingBoxBounds::nodes(const BoxTree& tree, const Primitives& ordered) {
    const auto [begin, end] = ordered.times();
    const BoxTree first = fitted_at(tree, ordered, begin), last = fitted_at(tree, ordered, end);
    std::vector<Node> nodes;
    nodes.reserve(tree.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        nodes.push_back({{first.nodes[i].planes, last.nodes[i].planes}, tree.nodes[i].first, tree.nodes[i].count});
    return nodes;
}

}  // namespace raylab
