#include "raylab/accelerator/bvh8/bvh8_build.h"

#include "raylab/accelerator/bvh8/bvh8_leaf_writer.h"
#include "raylab/accelerator/bvh8/bvh8_split.h"
#include "raylab/base/error.h"
#include "raylab/base/tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace raylab {

namespace {

using namespace bvh8_parts;

// A part that becomes a tree of its own, and whose child that is.
struct Subtree {
    ReferenceRange part;
    int depth;
    std::size_t parent, place;
};

// Appends nodes and leaves to a tree, depth first.
class Grower {
public:
    Grower(std::span<const Triangle> triangles, References& references, Bvh8Nodes& tree)
        : triangles_(triangles), references_(references), tree_(tree) {}

    // Parts of no more references than these are not grown but listed.
    std::size_t listed_below = 0;
    std::vector<Subtree> listed = {};

    std::size_t grow(const ReferenceRange& part, int depth) {
        std::array<ReferenceRange, bvh8_width> parts{part};
        const std::size_t count = divide(parts, depth);
        const std::size_t index = tree_.nodes.size();
        for (std::size_t i = 0; i < count; ++i)
            if (parts[i].size() <= bvh8_width) prefetch(parts[i]);
        tree_.nodes.emplace_back();
        for (std::size_t i = 0; i < count; ++i) set_box(tree_.nodes[index], i, parts[i].box);
        for (std::size_t i = 0; i < count; ++i) {
            if (references_.fit_in_leaf(parts[i])) {
                tree_.nodes[index].children[i] = leaf(parts[i]);
            } else if (parts[i].size() <= listed_below) {
                listed.push_back({parts[i], depth + 1, index, i});
            } else {
                const std::size_t child = grow(parts[i], depth + 1);
                tree_.nodes[index].children[i] = Bvh8Child::node(child);
            }
        }
        return index;
    }

private:
    // Prefetches the triangles of a node all at once, because they are scattered in memory.
    void prefetch(const ReferenceRange& part) const {
        for (const Reference& one : references_.of(part))
            if (one.is_triangle()) __builtin_prefetch(&triangles_[one.number()]);
    }

    static void set_box(Bvh8Node& node, std::size_t place, const Extent& box) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<std::size_t>(axis);
            node.planes[row][place] = box.min[axis] < -Bvh8Nodes::largest ? -infinity : box.min[axis];
            node.planes[row + 3][place] = box.max[axis] > Bvh8Nodes::largest ? infinity : box.max[axis];
        }
    }

    // Splits the largest part that is not a leaf until there are eight parts, or only leaves. Returns the number of
    // parts.
    std::size_t divide(std::array<ReferenceRange, bvh8_width>& parts, int depth) {
        std::size_t count = 1;
        while (count < bvh8_width) {
            ReferenceRange* largest = nullptr;
            for (std::size_t i = 0; i < count; ++i)
                if (!references_.fit_in_leaf(parts[i]) &&
                    (!largest || parts[i].box.half_area() > largest->box.half_area()))
                    largest = &parts[i];
            if (!largest) break;
            const auto [left, right] = references_.split(*largest, depth);
            *largest = left;
            parts[count++] = right;
        }
        return count;
    }

    Bvh8Child leaf(const ReferenceRange& part) {
        const std::span<const Reference> found = references_.of(part);
        if (!found[0].is_triangle()) {
            tree_.others.push_back(found[0].number());
            return Bvh8Child::leaf(Bvh8Child::Kind::others, tree_.others.size() - 1, 1);
        }
        Bvh8LeafWriter writer;
        for (const Reference& one : found) writer.add(triangles_[one.number()], one.number());
        return Bvh8Child::leaf(Bvh8Child::Kind::triangles, writer.append_to(tree_.leaves), found.size());
    }

    std::span<const Triangle> triangles_;
    References& references_;
    Bvh8Nodes& tree_;
};

class Builder {
public:
    Builder(std::span<const Triangle> triangles, std::span<const Box> others, const Bvh8BuildOptions& options)
        : triangles_(triangles), threads_(options.threads), references_(triangles, others, options) {
        set_corners();
        tree_.triangle_count = triangles.size();
    }

    // The top of the tree comes first, and then one subtree after the other: one thread appends them to it, several
    // grow them in trees of their own, which are then appended in the same order.
    Bvh8Nodes build() {
        if (references_.all().size() == 0) return {};
        reserve(tree_, references_.all().size());
        Grower top(triangles_, references_, tree_);
        top.listed_below = References::subtree_size;
        top.grow(references_.all(), 1);
        if (threads_ == 1)
            for (const Subtree& subtree : top.listed) {
                const std::size_t root = Grower(triangles_, references_, tree_).grow(subtree.part, subtree.depth);
                tree_.nodes[subtree.parent].children[subtree.place] = Bvh8Child::node(root);
            }
        else
            append(top.listed, grown(top.listed));
        give_back_rest(tree_.nodes);
        give_back_rest(tree_.leaves);
        if (tree_.leaves.size() > Bvh8Child::max_lines)
            throw Error(fmt::format("expected leaves of at most 8 GiB, found {} bytes",
                                    sizeof(Bvh8Line) * tree_.leaves.size()));
        return std::move(tree_);
    }

private:
    void set_corners() {
        std::vector<Extent> pieces((triangles_.size() + References::piece_size - 1) / References::piece_size);
        for_each_piece(triangles_.size(), References::piece_size, threads_, [&](std::size_t begin, std::size_t end) {
            Extent& piece = pieces[begin / References::piece_size];
            for (const Triangle& triangle : triangles_.subspan(begin, end - begin)) {
                piece.add(four(triangle.a));
                piece.add(four(triangle.b));
                piece.add(four(triangle.c));
            }
        });
        Extent all;
        for (const Extent& piece : pieces) all.add(piece);
        for (int axis = 0; axis < 3; ++axis)
            if (all.min[axis] < -Bvh8Nodes::farthest || all.max[axis] > Bvh8Nodes::farthest) tree_.is_far = true;
        tree_.min_corner = std::bit_cast<std::array<float, 4>>(all.min);
        tree_.largest_corner = std::bit_cast<std::array<float, 4>>(all.max);
    }

    static void reserve(Bvh8Nodes& tree, std::size_t references) {
        // Bytes for each triangle: those of meshes need 27 to 29.
        tree.leaves.reserve(references * 30 / sizeof(Bvh8Line));
        tree.nodes.reserve(references / 12 + 1);
    }

    // Frees unused memory where it is enough to be worth copying the rest.
    template <class T>
    static void give_back_rest(LargeVector<T>& some) {
        if (some.size() < some.capacity() / 8 * 7) some.shrink_to_fit();
    }

    std::vector<Bvh8Nodes> grown(const std::vector<Subtree>& subtrees) {
        std::vector<Bvh8Nodes> trees(subtrees.size());
        for_each_piece(subtrees.size(), 1, threads_, [&](std::size_t i, std::size_t) {
            reserve(trees[i], subtrees[i].part.size());
            Grower(triangles_, references_, trees[i]).grow(subtrees[i].part, subtrees[i].depth);
        });
        return trees;
    }

    void append(const std::vector<Subtree>& subtrees, const std::vector<Bvh8Nodes>& trees) {
        struct Start {
            std::size_t node, line, other;
        };
        std::vector<Start> starts;
        Start next{tree_.nodes.size(), tree_.leaves.size(), tree_.others.size()};
        for (std::size_t i = 0; i < trees.size(); ++i) {
            starts.push_back(next);
            tree_.nodes[subtrees[i].parent].children[subtrees[i].place] = Bvh8Child::node(next.node);
            next = {next.node + trees[i].nodes.size(), next.line + trees[i].leaves.size(),
                    next.other + trees[i].others.size()};
        }
        tree_.nodes.resize(next.node);
        tree_.leaves.resize(next.line);
        tree_.others.resize(next.other);
        for_each_piece(trees.size(), 1, threads_, [&](std::size_t i, std::size_t) {
            const auto [first_node, first_line, first_other] = starts[i];
            Bvh8Node* node = tree_.nodes.data() + first_node;
            for (const Bvh8Node& grown : trees[i].nodes) {
                *node = grown;
                for (Bvh8Child& child : node->children)
                    if (!child.is_root()) child = child.after(first_node, first_line, first_other);
                ++node;
            }
            std::ranges::copy(trees[i].leaves, tree_.leaves.data() + first_line);
            std::ranges::copy(trees[i].others, tree_.others.data() + first_other);
        });
    }

    std::span<const Triangle> triangles_;
    int threads_;
    References references_;
    Bvh8Nodes tree_;
};

}  // namespace

Bvh8Nodes build_bvh8_nodes(std::span<const Triangle> triangles, std::span<const Box> others,
                           const Bvh8BuildOptions& options) {
    const std::size_t count = triangles.size() + others.size();
    if (count > Bvh8Child::max_primitives)
        throw Error(fmt::format("expected at most 134 217 728 primitives, found {}", count));
    return Builder(triangles, others, options).build();
}

}  // namespace raylab
