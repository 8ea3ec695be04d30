#include "raylab/accelerator/bvh8/bvh8.h"

#include "raylab/accelerator/bvh8/bvh8_leaves.h"
#include "raylab/accelerator/bvh8/bvh8_walk_in_doubles.h"

namespace raylab {

void Bvh8::walk_in_doubles(const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) const {
    const Bvh8Nodes& tree = contents_.tree();
    if (!tree.nodes.empty()) WalkInDoubles(tree, query, leaves, traversal).visit(Bvh8Child::node(0));
}

std::optional<Hit> Bvh8::closest(const Ray& ray, Traversal& traversal) const {
    NearestLeaves leaves(contents_, ray, traversal);
    walk(walks_.nearest, {ray, leaves.end(), contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.hit();
}

bool Bvh8::occluded(const Ray& ray, Traversal& traversal) const {
    AnyLeaves leaves(contents_, ray, traversal);
    if (leaves.is_hit_at_once()) return true;
    walk(walks_.any, {ray, ray.range.max, contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.is_hit();
}

std::optional<Hit> Bvh8::closest_in_floats(const Ray& ray, Traversal& traversal) const {
    if (contents_.tree().nodes.empty()) return std::nullopt;
    NearestLeaves leaves(contents_, ray, traversal);
    walks_.plain(contents_.tree(), {ray, ray.range.max, contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.hit();
}

}  // namespace raylab
