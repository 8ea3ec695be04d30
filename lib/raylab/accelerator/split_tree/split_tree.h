#pragma once

#include "raylab/accelerator/split_tree/plane_rule.h"
#include "raylab/geometry/bounds/box.h"

#include <bit>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace raylab {

struct SortedPrimitives;

/// A binary tree of axis-aligned planes that cut a box into cells: a kd-tree, or an axis-aligned BSP tree.
struct SplitTree {
    static constexpr int max_depth = 64;

    /// Eight bytes (Pharr, Jakob and Humphreys, Physically Based Rendering, section 4.4). An inner node has a plane and
    /// the index of the half below it; the half above is the next node. A leaf has the place of its primitives in
    /// `parts` and their number.
    class Node {
    public:
        Node() : Node(leaf(0, 0)) {}
        static Node inner(std::size_t axis, float plane, std::size_t below) {
            return {plane, static_cast<std::uint32_t>(below << 2 | axis)};
        }
        static Node leaf(std::uint32_t first, std::uint32_t count) {
            return {std::bit_cast<float>(first), count << 2 | leaf_mark};
        }

        bool is_leaf() const { return (tagged_ & leaf_mark) == leaf_mark; }
        std::size_t axis() const { return tagged_ & leaf_mark; }
        float plane() const { return data_; }
        std::uint32_t below() const { return tagged_ >> 2; }
        std::uint32_t above() const { return below() + 1; }
        std::uint32_t first() const { return std::bit_cast<std::uint32_t>(data_); }
        std::uint32_t count() const { return tagged_ >> 2; }

    private:
        static constexpr std::uint32_t leaf_mark = 3;
        Node(float data, std::uint32_t tagged) : data_(data), tagged_(tagged) {}
        float data_;  // stored as a float, so that reading a plane needs no conversion
        std::uint32_t tagged_;
    };

    Box bounds;
    std::vector<Node> nodes;           // the root first; empty where there are no parts
    std::vector<std::uint32_t> parts;  // leaf after leaf, the indices of the boxes from which the tree was built

    std::span<const std::uint32_t> in(const Node& leaf) const {
        return std::span(parts).subspan(leaf.first(), leaf.count());
    }
};

/// Which of the boxes are about triangles, that are clipped where a plane cuts them.
using TriangleInBox = std::function<std::optional<Triangle>(std::uint32_t box)>;

/// Builds a tree over boxes, split by split as the rule says; it is at most 8 + 1.3 log2 n deep.
SplitTree build_split_tree(std::span<const Box> boxes, const TriangleInBox& triangle, const PlaneRule& rule);

/// The same over the bounded primitives.
SplitTree build_split_tree(const SortedPrimitives& sorted, const PlaneRule& rule);

}  // namespace raylab
