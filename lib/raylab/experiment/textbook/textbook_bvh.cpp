#include "raylab/experiment/textbook/textbook_bvh.h"

#include "raylab/accelerator/bvh/nearest_in_tree.h"
#include "raylab/geometry/box_entry.h"

#include <algorithm>

namespace raylab {

namespace {

// A child as its parent stores it: the root is node 0, and the children of the tree's i-th node are 2 i + 1 and 2 i
// + 2.
struct Child {
    std::uint32_t first, count;
};

Child child_of(const BoxTree& tree, int number) {
    if (number == 0) return {0, 0};
    const auto place = static_cast<std::size_t>(number - 1);
    const BoxTree::Node& parent = tree.nodes[place / 2];
    return {parent.first[place % 2], parent.count[place % 2]};
}

}  // namespace

TextbookBvh::TextbookBvh(const Scene& scene) : TextbookBvh(SortedPrimitives(scene)) {}

TextbookBvh::TextbookBvh(const SortedPrimitives& sorted)
    : tree_(build_box_tree(sorted.boxes)), bounded_(sorted.in_order(tree_.order)), unbounded_(sorted.without_bounds()) {
    for (const Box& box : sorted.boxes) all_ = unite(all_, box);
}

std::size_t TextbookBvh::bytes() const {
    return tree_.nodes.capacity() * sizeof(BoxTree::Node) + bounded_.bytes() + unbounded_.bytes();
}

std::optional<Hit> TextbookBvh::closest(const Ray& ray, Traversal& traversal) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < unbounded_.size(); ++i) unbounded_.test(i, ray, nearest, traversal);
    if (tree_.nodes.empty()) return nearest.hit();
    const RayOf<double> line = in<double>(ray);
    nearest_in_tree({.entry =
                         [&](int node) {
                             ++traversal.box_tests;
                             const auto place = static_cast<std::size_t>(std::max(node - 1, 0));
                             const Box box = node == 0 ? all_ : box_of(tree_.nodes[place / 2].planes, place % 2);
                             return box_entry(line, convert<double>(box.min), convert<double>(box.max));
                         },
                     .children = [&](int node) -> std::optional<std::array<int, 2>> {
                         const auto [first, count] = child_of(tree_, node);
                         if (count > 0) return std::nullopt;
                         ++traversal.steps;
                         const int left = 2 * static_cast<int>(first) + 1;
                         return std::array{left, left + 1};
                     },
                     .hit = [&](int leaf) -> std::optional<double> {
                         const auto [first, count] = child_of(tree_, leaf);
                         for (std::uint32_t i = first; i < first + count; ++i)
                             bounded_.test(i, ray, nearest, traversal);
                         return nearest.hit() ? std::optional<double>(nearest.limit()) : std::nullopt;
                     }});
    return nearest.hit();
}

}  // namespace raylab
