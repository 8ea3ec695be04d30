#include "raylab/accelerator/kd8/kd8.h"

#include "raylab/accelerator/bvh8/bvh8_leaves.h"
#include "raylab/accelerator/kd8/kd8_build.h"
#include "raylab/accelerator/kd8/kd8_walk_in_doubles.h"

#include <utility>

namespace raylab {

Kd8::Kd8(const Scene& scene, const PlaneRule& rule)
    : contents_(scene, Bvh8BuildOptions{}, [&](const TriangleRuns& triangles, std::span<const Box> others) {
          Kd8Tree tree = build_kd8(triangles, others, rule);
          cells_ = std::move(tree.cells);
          return std::move(tree.contents);
      }) {}

void Kd8::walk_in_doubles(const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) const {
    Kd8WalkInDoubles(cells_, contents_.tree(), query, leaves, traversal).visit();
}

std::optional<Hit> Kd8::closest(const Ray& ray, Traversal& traversal) const {
    NearestLeaves leaves(contents_, ray, traversal);
    walk(walks_.nearest, {ray, leaves.end(), contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.hit();
}

bool Kd8::occluded(const Ray& ray, Traversal& traversal) const {
    AnyLeaves leaves(contents_, ray, traversal);
    if (leaves.is_hit_at_once()) return true;
    walk(walks_.any, {ray, ray.range.max, contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.is_hit();
}

}  // namespace raylab
