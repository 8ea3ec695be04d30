#pragma once

#include "raylab/accelerator/bvh8/bvh8_walk_in_doubles.h"
#include "raylab/accelerator/kd8/kd8_node.h"
#include "raylab/accelerator/split_tree/split_ray.h"

namespace raylab {

/// The traversal in doubles, one plane after the other, with every triangle tested exactly: for rays for which floats
/// do not suffice.
class Kd8WalkInDoubles {
public:
    Kd8WalkInDoubles(const Kd8Cells& cells, const Bvh8Nodes& contents, const Bvh8Query& query, Bvh8Leaves& leaves,
                     Traversal& traversal)
        : cells_(cells),
          ray_(query.ray),
          in_leaves_(contents, query, leaves, traversal),
          leaves_(leaves),
          traversal_(traversal) {}

    void visit() {
        ++traversal_.box_tests;
        visit(cells_.root, ray_.inside(cells_.bounds));
    }

private:
    using Span = SplitRay<double>::Span;

    // False: the traversal ends.
    bool visit(Kd8Child child, const Span& span) {
        if (child.is_none() || span.is_empty() || !in_leaves_.reaches(span.begin)) return true;
        if (child.is_node()) {
            leaves_.came_to(Bvh8Child::node(child.first()));
            ++traversal_.steps;
            return visit(cells_.nodes[child.first()], 0, 0, span);
        }
        if (!child.is_list()) return in_leaves_.visit(child.leaf());
        for (const Bvh8Child leaf : cells_.leaves_of(child))
            if (!in_leaves_.visit(leaf)) return false;
        return true;
    }

    // The cells from `cell` on that a plane of this level parts.
    bool visit(const Kd8Node& node, int level, std::size_t cell, const Span& span) {
        if (level == 3) return visit(node.children[cell], span);
        const std::size_t place = Kd8Node::plane_between(cell, level), axis = node.children[place].axis();
        const auto crossing = ray_.crossing(axis, node.planes[place]);
        const std::size_t above = cell + (bvh8_width >> (level + 1));
        const bool from_above = ray_.nearer_half(axis) != 0;
        // (Written so that NaN does not leave a half out.)
        if (!(crossing.high < span.begin) &&
            !visit(node, level + 1, from_above ? above : cell, ray_.before(crossing, span)))
            return false;
        return crossing.low > span.end ||
               visit(node, level + 1, from_above ? cell : above, ray_.beyond(crossing, span));
    }

    const Kd8Cells& cells_;
    SplitRay<double> ray_;
    WalkInDoubles in_leaves_;
    Bvh8Leaves& leaves_;
    Traversal& traversal_;
};

}  // namespace raylab
