#include "raylab/accelerator/bvh/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace raylab {

namespace {

struct Slice {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
};

class Builder {
public:
    Builder(std::span<const Box> boxes, const BoxTreeOptions& options)
        : boxes_(boxes), options_(options), splitter_(boxes, options.rule) {
        tree_.order.resize(boxes.size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0u);
    }

    BoxTree build() {
        if (boxes_.empty()) return {};
        tree_.nodes.reserve(boxes_.size());
        grow({0, boxes_.size()}, 1);
        if (boxes_.size() == 1) tree_.nodes[0].hold(1, {}, 0, 1);
        tree_.nodes.shrink_to_fit();
        return std::move(tree_);
    }

private:
    std::uint32_t grow(Slice slice, int depth) {
        const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        const std::size_t middle = divide(slice, depth);
        set_child(index, 0, {slice.begin, middle}, depth);
        set_child(index, 1, {middle, slice.end}, depth);
        return index;
    }

    void set_child(std::uint32_t index, std::size_t side, Slice slice, int depth) {
        const Box box = box_about(slice);
        const bool leaf = slice.size() <= 1 || is_leaf(slice, box);
        const std::size_t first = leaf ? slice.begin : grow(slice, depth + 1);
        tree_.nodes[index].hold(side, box, first, leaf ? slice.size() : 0);
    }

    std::span<const std::uint32_t> boxes_in(Slice slice) const {
        return std::span(tree_.order).subspan(slice.begin, slice.size());
    }

    Box box_about(Slice slice) const {
        Box box;
        for (const std::uint32_t i : boxes_in(slice)) box = unite(box, boxes_[i]);
        return box;
    }

    bool is_leaf(Slice slice, const Box& box) const {
        if (slice.size() > options_.largest_leaf) return false;
        if (options_.rule == SplitRule::median) return true;  // the median rule has no cost to compare
        const auto split = splitter_.split(boxes_in(slice));
        const double area = surface_area(box);
        return !split || static_cast<double>(slice.size()) * area <= box_visit_cost * area + split->cost;
    }

    // Sorts the slice into two parts and returns where the second begins. With two or more boxes neither part is empty.
    std::size_t divide(Slice slice, int depth) {
        if (slice.size() < 2) return slice.end;
        const auto split = depth < BoxTree::halving_depth ? splitter_.split(boxes_in(slice)) : std::nullopt;
        const auto at = [&](std::size_t i) { return tree_.order.begin() + static_cast<std::ptrdiff_t>(i); };
        if (!split) return slice.begin + slice.size() / 2;
        const auto middle = std::partition(at(slice.begin), at(slice.end), [&](std::uint32_t i) {
            return splitter_.center(i, split->axis) < split->place;
        });
        const auto found = static_cast<std::size_t>(middle - tree_.order.begin());
        return found == slice.begin || found == slice.end ? slice.begin + slice.size() / 2 : found;
    }

    std::span<const Box> boxes_;
    BoxTreeOptions options_;
    BoxSplitter splitter_;
    BoxTree tree_;
};

}  // namespace

void BoxTree::Node::hold(std::size_t side, const Box& box, std::size_t first_place, std::size_t size) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        planes[axis][side] = box.min[static_cast<int>(axis)];
        planes[axis + 3][side] = box.max[static_cast<int>(axis)];
    }
    first[side] = static_cast<std::uint32_t>(first_place);
    count[side] = static_cast<std::uint32_t>(size);
}

Box box_of(const BoxTree::Planes& planes, std::size_t side) {
    return {{planes[0][side], planes[1][side], planes[2][side]}, {planes[3][side], planes[4][side], planes[5][side]}};
}

BoxTree build_box_tree(std::span<const Box> boxes, const BoxTreeOptions& options) {
    return Builder(boxes, options).build();
}

}  // namespace raylab
