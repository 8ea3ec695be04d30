#include "raylab/accelerator/wide/wide_tree.h"

#include "raylab/accelerator/wide/wide_leaves.h"
#include "raylab/accelerator/wide/wide_walk_in_doubles.h"

namespace raylab {

void WideTree::walk_in_doubles(const WideQuery& query, WideLeaves& leaves, Traversal& traversal) const {
    const WideNodes& tree = contents_.tree();
    if (!tree.nodes.empty()) WalkInDoubles(tree, query, leaves, traversal).visit(WideChild::node(0));
}

std::optional<Hit> WideTree::closest(const Ray& ray, Traversal& traversal) const {
    NearestLeaves leaves(contents_, ray, traversal);
    walk(walks_.nearest, {ray, leaves.end(), contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.hit();
}

bool WideTree::occluded(const Ray& ray, Traversal& traversal) const {
    AnyLeaves leaves(contents_, ray, traversal);
    if (traversal.stopped_again([&](std::size_t number) { return leaves.hits(number); })) return true;
    const Primitives& unbounded = contents_.unbounded();
    for (std::size_t i = 0; i < unbounded.size(); ++i)
        if (unbounded.hits(i, ray, traversal)) return true;
    walk(walks_.any, {ray, ray.range.max, contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.is_hit();
}

std::optional<Hit> WideTree::closest_in_floats(const Ray& ray, Traversal& traversal) const {
    if (contents_.tree().nodes.empty()) return std::nullopt;
    NearestLeaves leaves(contents_, ray, traversal);
    walks_.plain(contents_.tree(), {ray, ray.range.max, contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.hit();
}

}  // namespace raylab
