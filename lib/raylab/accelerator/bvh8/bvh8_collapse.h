#pragma once

#include "raylab/accelerator/bvh8/bvh8_parts.h"
#include "raylab/accelerator/bvh8/bvh8_split.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab::bvh8_parts {

/// A binary tree over a part, and which of its nodes become the nodes of the wide tree: those of the lowest expected
/// work. (I. Wald, C. Benthin, S. Boulos, Getting Rid of Packets, RT 2008, by dynamic programming; H. Ylitie, T.
/// Karras, S. Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, HPG 2017.)
///
/// A ray that hits the box of the part hits another one inside of it with the probability of their areas. So the work
/// of a node is its area times that of one step, and the work of its children. These are some of its descendants, at
/// most eight, that share out all leaves among them. What n children that stand for a binary node cost at least is the
/// least, over all k, of what k children that stand for its left half cost and n - k that stand for its right half. So
/// the numbers are found from the leaves upwards.
///
/// Where the child of the largest area is always split instead, rays visit up to a tenth more nodes in halls and
/// cities.
class CollapsedTree {
public:
    CollapsedTree(References& references, const ReferenceRange& part, int depth);

    /// A part that becomes a child of a wide node: a leaf, or a node whose children are asked for in turn.
    struct Part {
        std::size_t at;
        bool is_leaf;
    };
    static constexpr std::size_t root = 0;
    struct Children {
        std::array<Part, bvh8_width> parts;
        std::size_t count = 0;
    };
    /// Of the wide node that stands for a part. (A root that is a leaf is its own child.)
    Children children(std::size_t at) const;

    const ReferenceRange& range(Part part) const { return nodes_[part.at].part; }

private:
    struct Node {
        ReferenceRange part;
        std::uint32_t left = 0, right = 0;  // 0: a leaf
        // By how many children may stand for it: the least work, and how many of them stand for the left half.
        std::array<float, bvh8_width + 1> work;
        std::array<std::uint8_t, bvh8_width + 1> of_left;
    };
    std::uint32_t grow(const ReferenceRange& part, int depth);
    void expect_work(Node& node) const;
    void add_children(std::size_t at, std::size_t most, Children& children) const;

    References& references_;
    ThreadPool alone_;
    std::vector<Node> nodes_;
};

}  // namespace raylab::bvh8_parts
