#include "raylab/accelerator/bvh8/bvh8_build.h"

#include "raylab/accelerator/bvh8/bvh8_any_order.h"
#include "raylab/accelerator/bvh8/bvh8_binary_top.h"
#include "raylab/accelerator/bvh8/bvh8_collapse.h"
#include "raylab/accelerator/bvh8/bvh8_leaf_writer.h"
#include "raylab/base/error.h"
#include "raylab/base/thread_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <shared_mutex>
#include <tuple>
#include <vector>

namespace raylab {

namespace {

using namespace bvh8_parts;

// Parts of no more references are grown by one thread each, and of no more than a piece. (The larger they are, the
// fewer nodes a ray visits: CollapsedTree makes them.)
constexpr std::size_t max_subtree_size = 8192;

// A part that becomes a tree of its own, and whose child that is.
struct Subtree {
    BinaryTop::Part part;
    int depth;
    std::size_t parent, place;
};

// Appends nodes and leaves to a tree.
class Grower {
    using Parts = std::vector<BinaryTop::Part>;

public:
    Grower(const TriangleRuns& triangles, References& references, Bvh8Nodes& tree)
        : triangles_(triangles), references_(references), tree_(tree) {}

    // Grows the top of a tree level by level, and returns the parts below it that are small enough, in the order of
    // their references.
    std::vector<Subtree> grow_top(ThreadPool& threads) {
        const std::size_t size = std::min(references_.piece_size(), max_subtree_size);
        const BinaryTop top(references_, size, threads);
        std::vector<Subtree> small, level = append_node(divided(top, top.roots(), 1), 1);
        while (!level.empty()) {
            const auto large =
                std::ranges::partition(level, [&](const Subtree& one) { return one.part.range.size() <= size; });
            small.insert(small.end(), level.begin(), large.begin());
            level.erase(level.begin(), large.begin());
            level = append_nodes(top, level, threads);
        }
        std::ranges::sort(small, {}, [](const Subtree& one) { return one.part.range.begin; });
        return small;
    }

    void grow(const ReferenceRange& part, int depth) {
        const CollapsedTree binary(references_, part, depth);
        grow(binary, CollapsedTree::root);
    }

private:
    // Appends the nodes of a level, and returns the parts of the next.
    std::vector<Subtree> append_nodes(const BinaryTop& top, const std::vector<Subtree>& level, ThreadPool& threads) {
        std::vector<Parts> parts(level.size());
        threads.for_each_in_turn(level.size(),
                                 [&](std::size_t i) { parts[i] = divided(top, {level[i].part}, level[i].depth); });
        std::vector<Subtree> next;
        for (std::size_t i = 0; i < level.size(); ++i) {
            tree_.nodes[level[i].parent].children[level[i].place] = Bvh8Child::node(tree_.nodes.size());
            for (const Subtree& below : append_node(parts[i], level[i].depth)) next.push_back(below);
        }
        return next;
    }

    // Appends a node with its leaves, and returns those of its parts that are more than a leaf.
    std::vector<Subtree> append_node(const Parts& parts, int depth) {
        const std::size_t index = tree_.nodes.size();
        tree_.nodes.push_back(Bvh8Node::without_children());
        std::vector<Subtree> larger;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const ReferenceRange& range = parts[i].range;
            set_box(tree_.nodes[index], i, range.box);
            if (references_.fit_in_leaf(range))
                tree_.nodes[index].children[i] = leaf(range);
            else
                larger.push_back({parts[i], depth + 1, index, i});
        }
        return larger;
    }

    std::size_t grow(const CollapsedTree& binary, std::size_t at) {
        const CollapsedTree::Children children = binary.children(at);
        const std::span parts = std::span(children.parts).first(children.count);
        prefetch(binary, parts);
        const std::size_t index = tree_.nodes.size();
        tree_.nodes.push_back(Bvh8Node::without_children());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const ReferenceRange& part = binary.range(parts[i]);
            set_box(tree_.nodes[index], i, part.box);
            const Bvh8Child child = parts[i].is_leaf ? leaf(part) : Bvh8Child::node(grow(binary, parts[i].at));
            tree_.nodes[index].children[i] = child;
        }
        return index;
    }

    // Prefetches the triangles of a node's leaves all at once.
    void prefetch(const CollapsedTree& binary, std::span<const CollapsedTree::Part> parts) const {
        const auto for_each_number = [&](const auto& prefetch_of) {
            for (const CollapsedTree::Part part : parts)
                if (part.is_leaf)
                    for (const Reference& one : references_.of(binary.range(part)))
                        if (one.is_triangle()) prefetch_of(one.number());
        };
        for_each_number([&](std::uint32_t number) { triangles_.prefetch_names(number); });
        for_each_number([&](std::uint32_t number) { triangles_.prefetch_corners(number); });
    }

    static void set_box(Bvh8Node& node, std::size_t place, const Extent& box) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<std::size_t>(axis);
            node.planes[row][place] = box.min[axis] < -Bvh8Nodes::largest ? -infinity : box.min[axis];
            node.planes[row + 3][place] = box.max[axis] > Bvh8Nodes::largest ? infinity : box.max[axis];
        }
    }

    // Splits the part of the largest area that is not a leaf until there are eight parts, or only leaves.
    Parts divided(const BinaryTop& top, Parts parts, int depth) const {
        while (parts.size() < bvh8_width) {
            BinaryTop::Part* largest = nullptr;
            for (BinaryTop::Part& part : parts)
                if (!references_.fit_in_leaf(part.range) &&
                    (!largest || part.range.box.half_area() > largest->range.box.half_area()))
                    largest = &part;
            if (!largest) break;
            const auto [left, right] = top.halves(*largest, depth);
            *largest = left;
            parts.push_back(right);
        }
        return parts;
    }

    Bvh8Child leaf(const ReferenceRange& part) {
        const std::span<const Reference> found = references_.of(part);
        if (!found[0].is_triangle()) {
            tree_.others.push_back(found[0].number());
            return Bvh8Child::leaf(Bvh8Child::Kind::others, tree_.others.size() - 1, 1);
        }
        Bvh8LeafWriter writer;
        for (const Reference& one : found) {
            const std::uint32_t number = one.number();
            writer.add(triangles_[number], number, triangles_.sides(number));
        }
        return Bvh8Child::leaf(Bvh8Child::Kind::triangles, writer.append_to(tree_.leaves), found.size());
    }

    const TriangleRuns& triangles_;
    References& references_;
    Bvh8Nodes& tree_;
};

class Builder {
    struct Grown {
        Bvh8Nodes tree;
        AnyHitOrder::Expected expected;
    };

public:
    Builder(const TriangleRuns& triangles, std::span<const Box> others, const Bvh8BuildOptions& options)
        : triangles_(triangles),
          threads_(options.threads, (triangles.size() + others.size()) / References::min_piece_size),
          references_(triangles, others, options, threads_) {
        // The boxes hold all corners, and what is farther than a box may be is far, too.
        tree_.enclose(box_of(references_.corners()), box_of(references_.all().box));
        tree_.triangle_count = triangles.size();
    }

    // The top of the tree comes first, and then one subtree after the other. Threads grow subtrees, each in a tree of
    // its own, and whoever completes the next one gives it a place.
    Bvh8Nodes build() {
        if (references_.all().size() == 0) return {};
        reserve(tree_, references_.all().size());
        const std::vector<Subtree> subtrees = Grower(triangles_, references_, tree_).grow_top(threads_);
        const std::size_t nodes_of_top = tree_.nodes.size();
        grow_and_append(subtrees);
        order_.arrange(tree_, nodes_of_top);
        references_.release();
        give_back_rest(tree_.nodes);
        give_back_rest(tree_.leaves);
        if (tree_.leaves.size() > Bvh8Child::max_lines)
            throw Error(fmt::format("expected leaves of at most 8 GiB, found {} bytes",
                                    sizeof(Bvh8Line) * tree_.leaves.size()));
        if (tree_.nodes.size() > Bvh8Child::max_nodes)
            throw Error(fmt::format("expected at most {} nodes, found {}", Bvh8Child::max_nodes, tree_.nodes.size()));
        return std::move(tree_);
    }

private:
    static Box box_of(const Extent& extent) {
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            box.min[axis] = extent.min[axis];
            box.max[axis] = extent.max[axis];
        }
        return box;
    }

    static void reserve(Bvh8Nodes& tree, std::size_t references) {
        // Bytes for each triangle: those of meshes need 27 to 29.
        tree.leaves.reserve(references * 30 / sizeof(Bvh8Line));
        tree.nodes.reserve(references / 12 + 1);
    }

    // Frees what was reserved and is not used, if that is much. Beyond the size of a large page that is not worth a
    // copy: the system has given no memory for pages that nothing has touched.
    template <class T>
    static void give_back_rest(LargeVector<T>& some) {
        const bool is_much = some.capacity() - some.size() > some.size() / 8;
        if (is_much && some.capacity() * sizeof(T) < large_page) some.shrink_to_fit();
    }

    // A grown subtree, and where in the tree it lies.
    struct Placed {
        Bvh8Nodes subtree;
        std::size_t nodes, lines, others;  // those before it
    };

    // In which order subtrees are grown: of so many that stand together the largest first, so that the threads are done
    // at the same time, and yet not many wait for their place.
    static std::vector<std::size_t> large_ones_first(const std::vector<Subtree>& subtrees) {
        constexpr std::size_t together = 32;
        std::vector<std::size_t> order(subtrees.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::sort(order, {}, [&](std::size_t i) {
            return std::tuple(i / together, -static_cast<std::ptrdiff_t>(subtrees[i].part.range.size()), i);
        });
        return order;
    }

    // A lock is held while places are given, in order; to copy a subtree to its place takes as long as to make it on
    // fresh memory, so each thread does that for itself.
    void grow_and_append(const std::vector<Subtree>& subtrees) {
        const std::vector<std::size_t> order = large_ones_first(subtrees);
        std::vector<Grown> waiting(subtrees.size());  // for those before them
        std::size_t next = 0;
        std::mutex guards_places;
        threads_.for_each_in_turn(subtrees.size(), [&](std::size_t turn) {
            const std::size_t i = order[turn];
            Bvh8Nodes own;
            reserve(own, subtrees[i].part.range.size());
            Grower(triangles_, references_, own).grow(subtrees[i].part.range, subtrees[i].depth);
            const AnyHitOrder::Expected expected = AnyHitOrder().arrange(own, own.nodes.size());
            std::vector<Placed> placed;
            {
                const std::lock_guard lock(guards_places);
                waiting[i] = {std::move(own), expected};
                for (; next < waiting.size() && !waiting[next].tree.nodes.empty(); ++next)
                    placed.push_back(place(subtrees[next], std::move(waiting[next])));
            }
            for (const Placed& one : placed) copy(one);
        });
    }

    Placed place(const Subtree& subtree, Grown grown) {
        const std::size_t nodes = tree_.nodes.size(), lines = tree_.leaves.size(), others = tree_.others.size();
        tree_.nodes[subtree.parent].children[subtree.place] = Bvh8Child::node(nodes);
        order_.know(nodes, grown.expected);
        make_room(tree_.nodes, grown.tree.nodes.size());
        make_room(tree_.leaves, grown.tree.leaves.size());
        tree_.others.insert(tree_.others.end(), grown.tree.others.begin(), grown.tree.others.end());
        return {std::move(grown.tree), nodes, lines, others};
    }

    // Nothing moves while a thread copies to where it was.
    template <class T>
    void make_room(LargeVector<T>& some, std::size_t more) {
        const std::size_t size = some.size() + more;
        if (size > some.capacity()) {
            const std::lock_guard lock(guards_memory_);
            some.reserve(std::max(size, 2 * some.capacity()));
        }
        some.resize(size);
    }

    void copy(const Placed& placed) {
        const std::shared_lock lock(guards_memory_);
        Bvh8Node* to = tree_.nodes.data() + placed.nodes;
        for (const Bvh8Node& node : placed.subtree.nodes) {
            *to = node;
            for (Bvh8Child& child : to++->children)
                if (!child.is_root()) child = child.after(placed.nodes, placed.lines, placed.others);
        }
        std::ranges::copy(placed.subtree.leaves, tree_.leaves.data() + placed.lines);
    }

    const TriangleRuns& triangles_;
    ThreadPool threads_;
    References references_;
    Bvh8Nodes tree_;
    std::shared_mutex guards_memory_;  // of tree_, against its growth
    AnyHitOrder order_;
};

}  // namespace

Bvh8Nodes build_bvh8_nodes(const TriangleRuns& triangles, std::span<const Box> others,
                           const Bvh8BuildOptions& options) {
    const std::size_t count = triangles.size() + others.size();
    if (count > Bvh8Child::max_primitives)
        throw Error(fmt::format("expected at most 134 217 728 primitives, found {}", count));
    return Builder(triangles, others, options).build();
}

}  // namespace raylab
