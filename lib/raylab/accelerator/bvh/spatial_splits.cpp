#include "raylab/accelerator/bvh/spatial_splits.h"

#include "raylab/accelerator/bvh/part_halves.h"
#include "raylab/accelerator/split_tree/clipped_bounds.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace raylab {

namespace {

// A child to be built: a leaf or another node.
struct Branch {
    std::vector<CellPart> parts;
    std::size_t parent, side;
    int depth;
    Box box = box_about(parts);
    double work = surface_area(box) * static_cast<double>(parts.size());
};

// A box that reaches to infinity has an infinite area, or NaN.
bool less_work(const Branch& a, const Branch& b) {
    constexpr double largest = std::numeric_limits<double>::max();
    return (a.work <= largest ? a.work : largest) < (b.work <= largest ? b.work : largest);
}

// Children are built in the order of their work: those with the most to gain are the first to be allowed duplicates.
class SpatialBuilder {
public:
    SpatialBuilder(const SortedPrimitives& sorted, const SpatialSplits& options)
        : sorted_(sorted),
          options_(options),
          max_parts_((1 + options.max_duplicates) * static_cast<double>(sorted.boxes.size())) {}

    BoxTree build() {
        Branch root{.parts = {}, .parent = 0, .side = 0, .depth = 0};
        for (const Box& box : sorted_.boxes) root.parts.push_back({box, static_cast<std::uint32_t>(root.parts.size())});
        parts_ = root.parts.size();
        root.box = box_about(root.parts);
        min_overlap_ = options_.min_overlap * surface_area(root.box);
        auto halves = divided(root);
        add_node(root, halves ? std::move(*halves) : cut_in_the_middle(root.parts));
        while (!waiting_.empty()) {
            std::ranges::pop_heap(waiting_, less_work);
            const Branch next = std::move(waiting_.back());
            waiting_.pop_back();
            if (auto both = divided(next))
                hold(next, add_node(next, std::move(*both)), 0);
            else
                add_leaf(next);
        }
        return std::move(tree_);
    }

private:
    std::size_t add_node(const Branch& branch, PartHalves halves) {
        const std::size_t node = tree_.nodes.size();
        tree_.nodes.emplace_back();
        parts_ += halves.below.size() + halves.above.size() - branch.parts.size();
        wait({.parts = std::move(halves.below), .parent = node, .side = 0, .depth = branch.depth + 1});
        wait({.parts = std::move(halves.above), .parent = node, .side = 1, .depth = branch.depth + 1});
        return node;
    }

    void add_leaf(const Branch& branch) {
        hold(branch, tree_.order.size(), branch.parts.size());
        for (const CellPart& part : branch.parts) tree_.order.push_back(part.index);
    }

    void hold(const Branch& branch, std::size_t first, std::size_t count) {
        tree_.nodes[branch.parent].hold(branch.side, branch.box, first, count);
    }

    void wait(Branch branch) {
        waiting_.push_back(std::move(branch));
        std::ranges::push_heap(waiting_, less_work);
    }

    // Absent: the branch becomes a leaf.
    std::optional<PartHalves> divided(const Branch& branch) const {
        const std::size_t size = branch.parts.size();
        if (size <= 1) return std::nullopt;
        auto cut = branch.depth < BoxTree::halving_depth ? best_cut(branch) : std::nullopt;
        const bool pays = cut && box_visit_cost * surface_area(branch.box) + cut->cost < branch.work;
        if (!pays && size <= options_.largest_leaf) return std::nullopt;
        return cut ? std::move(cut->halves) : cut_in_the_middle(branch.parts);
    }

    std::optional<PartCut> best_cut(const Branch& branch) const {
        auto between = cut_between_centers(branch.parts);
        if (between) {
            const Box overlap = intersection(box_about(between->halves.below), box_about(between->halves.above));
            if (!(surface_area(overlap) > min_overlap_)) return between;
        }
        const double cost = between ? between->cost : std::numeric_limits<double>::infinity();
        const auto most_cut = static_cast<std::size_t>(max_parts_ - static_cast<double>(parts_));
        auto plane = cut_by_plane(sorted_, branch.parts, cost, most_cut);
        return plane ? std::move(plane) : std::move(between);
    }

    const SortedPrimitives& sorted_;
    SpatialSplits options_;
    double max_parts_, min_overlap_ = 0;
    std::size_t parts_ = 0;        // how many parts there are so far
    std::vector<Branch> waiting_;  // a heap
    BoxTree tree_;
};

// Copies a tree in the order of a traversal, so that nodes that are visited one after the other are neighbours in
// memory.
class WalkOrder {
public:
    explicit WalkOrder(const BoxTree& tree) : tree_(tree) {
        sorted_.nodes.reserve(tree.nodes.size());
        sorted_.order.reserve(tree.order.size());
        copy(0);
    }
    BoxTree taken() { return std::move(sorted_); }

private:
    std::uint32_t copy(std::size_t node) {
        const std::size_t place = sorted_.nodes.size();
        sorted_.nodes.push_back(tree_.nodes[node]);
        for (const std::size_t side : {0, 1}) {
            const auto [first, count] = std::pair(tree_.nodes[node].first[side], tree_.nodes[node].count[side]);
            sorted_.nodes[place].first[side] = count > 0 ? copy_leaf(first, count) : copy(first);
        }
        return static_cast<std::uint32_t>(place);
    }

    std::uint32_t copy_leaf(std::size_t first, std::size_t count) {
        const auto place = static_cast<std::uint32_t>(sorted_.order.size());
        const auto leaf = std::span(tree_.order).subspan(first, count);
        sorted_.order.insert(sorted_.order.end(), leaf.begin(), leaf.end());
        return place;
    }

    const BoxTree& tree_;
    BoxTree sorted_;
};

}  // namespace

BoxTree build_tree_with_spatial_splits(const SortedPrimitives& sorted, const SpatialSplits& options) {
    if (sorted.boxes.size() <= 1) return build_box_tree(sorted.boxes);  // nothing to split
    return WalkOrder(SpatialBuilder(sorted, options).build()).taken();
}

}  // namespace raylab
