#include "raylab/accelerator/sorted_primitives.h"
#include "raylab/accelerator/split_tree/split_tree.h"

#include <cmath>
#include <utility>

namespace raylab {

namespace {

class Builder {
public:
    Builder(std::span<const Box> boxes, const TriangleInBox& triangle, const PlaneRule& rule)
        : boxes_(boxes), triangle_(&triangle), rule_(&rule), max_parts_(100 * boxes.size() + 1000) {
        const double levels = 8 + 1.3 * std::log2(static_cast<double>(boxes.size()));
        deepest_ = std::min(SplitTree::max_depth, static_cast<int>(levels));
    }

    SplitTree build() {
        std::vector<CellPart> parts;
        for (const Box& box : boxes_) {
            parts.push_back({box, static_cast<std::uint32_t>(parts.size())});
            tree_.bounds = unite(tree_.bounds, box);
        }
        tree_.nodes.emplace_back();
        grow(0, tree_.bounds, std::move(parts), 1);
        tree_.nodes.shrink_to_fit();
        tree_.parts.shrink_to_fit();
        return std::move(tree_);
    }

private:
    void grow(std::size_t index, const Box& cell, std::vector<CellPart> parts, int depth) {
        const auto split = may_split(depth) ? (*rule_)(cell, parts) : std::nullopt;
        if (!split) {
            tree_.nodes[index] = leaf(parts);
            return;
        }
        const std::size_t children = tree_.nodes.size();
        tree_.nodes[index] = SplitTree::Node::inner(split->axis, split->at, children);
        tree_.nodes.resize(children + 2);
        auto halves = divide(parts, *split);
        parts = {};
        Box below = cell, above = cell;
        below.max[static_cast<int>(split->axis)] = above.min[static_cast<int>(split->axis)] = split->at;
        grow(children, below, std::move(halves.below), depth + 1);
        grow(children + 1, above, std::move(halves.above), depth + 1);
    }

    // Where splits do not separate parts that overlap, a limit of the depth alone would allow 2^depth copies.
    bool may_split(int depth) const { return depth < deepest_ && tree_.parts.size() < max_parts_; }

    SplitTree::Node leaf(const std::vector<CellPart>& parts) {
        const auto first = static_cast<std::uint32_t>(tree_.parts.size());
        for (const CellPart& part : parts) tree_.parts.push_back(part.index);
        return SplitTree::Node::leaf(first, static_cast<std::uint32_t>(parts.size()));
    }

    // A point of a primitive in the plane itself is found in either half, because a ray that hits it there visits both;
    // so it is enough that each part is in the halves into which it reaches.
    struct Halves {
        std::vector<CellPart> below, above;
    };
    Halves divide(const std::vector<CellPart>& parts, const SplitPlane& split) const {
        Halves halves;
        const auto axis = static_cast<int>(split.axis);
        for (const CellPart& part : parts) {
            const float low = part.box.min[axis], high = part.box.max[axis];
            if (low < split.at && high > split.at) {
                cut(part, axis, split.at, halves);
            } else if (high > split.at || (low == split.at && split.in_plane == SplitPlane::InPlane::above)) {
                halves.above.push_back(part);
            } else {
                halves.below.push_back(part);
            }
        }
        return halves;
    }

    void cut(const CellPart& part, int axis, float at, Halves& halves) const {
        const auto [below, above] = cut_part(part, (*triangle_)(part.index), axis, at);
        if (!below.is_empty()) halves.below.push_back({below, part.index});
        if (!above.is_empty()) halves.above.push_back({above, part.index});
    }

    std::span<const Box> boxes_;
    const TriangleInBox* triangle_;
    const PlaneRule* rule_;
    std::size_t max_parts_;
    int deepest_;
    SplitTree tree_;
};

}  // namespace

SplitTree build_split_tree(std::span<const Box> boxes, const TriangleInBox& triangle, const PlaneRule& rule) {
    return boxes.empty() ? SplitTree{} : Builder(boxes, triangle, rule).build();
}

SplitTree build_split_tree(const SortedPrimitives& sorted, const PlaneRule& rule) {
    const auto triangle = [&](std::uint32_t box) { return sorted.triangle(box); };
    return build_split_tree(sorted.boxes, triangle, rule);
}

}  // namespace raylab
