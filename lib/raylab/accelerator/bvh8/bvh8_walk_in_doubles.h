#pragma once

#include "raylab/accelerator/bvh/ray_box.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"

#include <algorithm>
#include <array>

namespace raylab {

/// The traversal in doubles, one box after the other, with every triangle tested exactly: for rays for which floats do
/// not suffice.
class WalkInDoubles {
public:
    WalkInDoubles(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal)
        : tree_(tree), ray_(query.ray), leaving_(query.leaving), leaves_(leaves), traversal_(traversal) {
        ray_.set_end(query.end);
    }

    /// Whether what the ray enters at t is still reached before its end.
    bool reaches(double t) const { return ray_.reaches(t); }

    /// False: the traversal ends.
    bool visit(Bvh8Child child) {
        leaves_.came_to(child);
        if (child.kind() == Bvh8Child::Kind::others) return go_on_to(leaves_.others(child));
        if (child.is_node()) return visit(tree_.nodes[child.first()]);
        for (std::size_t place = 0; place < child.count(); ++place) {
            if (tree_.number(child, place) == leaving_) continue;
            ++traversal_.primitive_tests;
            if (!go_on_to(leaves_.uncertain(child, place))) return false;
        }
        return true;
    }

private:
    bool visit(const Bvh8Node& node) {
        ++traversal_.steps;
        traversal_.box_tests += bvh8_width;
        std::array<double, bvh8_width> entries;
        std::array<std::size_t, bvh8_width> order;
        for (std::size_t i = 0; i < bvh8_width; ++i) {
            BoxTree::Planes planes;
            for (std::size_t row = 0; row < 6; ++row) planes[row].fill(node.planes[row][i]);
            entries[i] = ray_.entries(planes)[0];
            order[i] = i;
        }
        std::ranges::sort(order, {}, [&](std::size_t i) { return entries[i]; });
        for (const std::size_t i : order)
            if (ray_.reaches(entries[i]) && !visit(node.children[i])) return false;
        return true;
    }

    bool go_on_to(double end) {
        ray_.set_end(end);
        return end != Bvh8Leaves::nothing_more;
    }

    const Bvh8Nodes& tree_;
    BoxRay ray_;
    std::uint32_t leaving_;
    Bvh8Leaves& leaves_;
    Traversal& traversal_;
};

[[gnu::noinline]] inline void walk_in_doubles(const Bvh8Nodes& tree, const Bvh8Query& query, Bvh8Leaves& leaves,
                                              Traversal& traversal) {
    if (!tree.nodes.empty()) WalkInDoubles(tree, query, leaves, traversal).visit(Bvh8Child::node(0));
}

}  // namespace raylab
