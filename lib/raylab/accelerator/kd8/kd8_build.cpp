#include "raylab/accelerator/kd8/kd8_build.h"

#include "raylab/accelerator/bvh8/bvh8_leaf_writer.h"
#include "raylab/accelerator/split_tree/split_tree.h"
#include "raylab/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace raylab {

namespace {

class Builder {
public:
    Builder(const TriangleRuns& triangles, std::span<const Box> others, const PlaneRule& rule) : triangles_(triangles) {
        std::vector<Box> boxes;
        boxes.reserve(triangles.size() + others.size());
        for (std::size_t i = 0; i < triangles.size(); ++i) boxes.push_back(bounds(triangles[i]));
        Box corners;
        for (const Box& box : boxes) corners = unite(corners, box);
        boxes.insert(boxes.end(), others.begin(), others.end());
        split_ = build_split_tree(
            boxes, [this](std::uint32_t box) { return triangle(box); }, rule);
        tree_.contents.triangle_count = triangles.size();
        tree_.contents.enclose(corners, split_.bounds);
        tree_.cells.bounds = split_.bounds;
    }

    Kd8Tree build() {
        if (!split_.nodes.empty()) tree_.cells.root = grown(0);
        Bvh8Nodes& contents = tree_.contents;
        if (std::max({bvh8_width * contents.leaves.size(), tree_.cells.nodes.size(), tree_.cells.lists.size()}) >
            Kd8Child::max_places)
            throw Error(fmt::format("expected leaves of at most 2 GiB, found {} bytes",
                                    sizeof(Bvh8Line) * contents.leaves.size()));
        contents.leaves.shrink_to_fit();
        tree_.cells.nodes.shrink_to_fit();
        tree_.cells.lists.shrink_to_fit();
        return std::move(tree_);
    }

private:
    std::optional<Triangle> triangle(std::uint32_t box) const {
        return box < triangles_.size() ? std::optional(triangles_[box]) : std::nullopt;
    }

    Kd8Child grown(std::uint32_t from) {
        const SplitTree::Node& parted = split_.nodes[from];
        if (parted.is_leaf()) return leaf(parted);
        const std::size_t index = tree_.cells.nodes.size();
        tree_.cells.nodes.emplace_back();
        Kd8Node node;
        node.children.fill(Kd8Child::none());
        grow(node, from, 0, 0, parted);
        tree_.cells.nodes[index] = node;
        return Kd8Child::node(index);
    }

    // Sets the planes and the contents of a part, which consists of 8, 4, 2 or 1 cells from `cell` on. A leaf is parted
    // again by the plane that parted it from its other half, and lies in the cell beside that.
    void grow(Kd8Node& node, std::uint32_t from, int level, std::size_t cell, const SplitTree::Node& parent) {
        const SplitTree::Node& parted = split_.nodes[from];
        const std::size_t count = bvh8_width >> level;
        if (level == 3) {
            set_content(node, cell, grown(from));
        } else if (parted.is_leaf()) {
            for (int again = level; again < 3; ++again) set_planes(node, cell, count, again, parent);
            set_content(node, Kd8Node::is_above(cell, level - 1) ? cell + count - 1 : cell, leaf(parted));
        } else {
            set_planes(node, cell, count, level, parted);
            grow(node, parted.below(), level + 1, cell, parted);
            grow(node, parted.above(), level + 1, cell + count / 2, parted);
        }
    }

    // (The axes of planes and what lies in cells share words: each of the two keeps the other's bits.)
    static void set_content(Kd8Node& node, std::size_t cell, Kd8Child content) {
        node.children[cell] = content.across(node.children[cell].axis());
    }
    static void set_planes(Kd8Node& node, std::size_t cell, std::size_t count, int level, const SplitTree::Node& to) {
        for (std::size_t i = cell; i < cell + count; ++i) {
            const std::size_t place = Kd8Node::plane_between(i, level);
            node.planes[place] = to.plane();
            node.children[place] = node.children[place].across(to.axis());
        }
    }

    Kd8Child leaf(const SplitTree::Node& of) {
        std::vector<Bvh8Child> leaves;
        std::vector<std::uint32_t> triangles;
        Bvh8Nodes& contents = tree_.contents;
        for (const std::uint32_t box : split_.in(of)) {
            if (box < triangles_.size()) {
                triangles.push_back(box);
            } else {
                contents.others.push_back(box - static_cast<std::uint32_t>(triangles_.size()));
                leaves.push_back(Bvh8Child::leaf(Bvh8Child::Kind::others, contents.others.size() - 1, 1));
            }
        }
        for (std::size_t i = 0; i < triangles.size(); i += bvh8_width) {
            const std::size_t count = std::min(bvh8_width, triangles.size() - i);
            leaves.push_back(leaf(std::span(triangles).subspan(i, count)));
        }
        if (leaves.empty()) return Kd8Child::none();
        if (leaves.size() == 1 && leaves[0].kind() == Bvh8Child::Kind::triangles) return Kd8Child::leaf(leaves[0]);
        std::vector<Bvh8Child>& lists = tree_.cells.lists;
        const std::size_t first = lists.size();
        lists.insert(lists.end(), leaves.begin(), leaves.end());
        lists.push_back(Bvh8Child::none());
        return Kd8Child::list(first);
    }

    Bvh8Child leaf(std::span<const std::uint32_t> of) {
        Bvh8LeafWriter writer;
        for (const std::uint32_t number : of) writer.add(triangles_[number], number, triangles_.sides(number));
        return Bvh8Child::leaf(Bvh8Child::Kind::triangles, writer.append_to(tree_.contents.leaves), of.size());
    }

    const TriangleRuns& triangles_;
    SplitTree split_;
    Kd8Tree tree_;
};

}  // namespace

Kd8Tree build_kd8(const TriangleRuns& triangles, std::span<const Box> others, const PlaneRule& rule) {
    return Builder(triangles, others, rule).build();
}

}  // namespace raylab
