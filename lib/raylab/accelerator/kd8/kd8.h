#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh8/bvh8_contents.h"
#include "raylab/accelerator/kd8/kd8_node.h"
#include "raylab/accelerator/kd8/kd8_walk.h"
#include "raylab/accelerator/split_tree/plane_rule.h"

namespace raylab {

/// A kd-tree as fast as we know how: three levels of planes are crossed at once, and what lies in its cells is tested
/// as in bvh8, eight triangles at once.
class Kd8 final : public Accelerator {
public:
    /// Of the surface area heuristic: a visit costs more tests than in a binary tree, because many are made at once.
    /// (Of the values tried, the fastest for scans.)
    static constexpr SahCosts costs{.visit = 6, .test = 1, .empty_bonus = 0.1};

    explicit Kd8(const Scene& scene, const PlaneRule& rule = surface_area_heuristic(costs));

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override { return cells_.bytes() + contents_.bytes(); }
    Outline outline() const override;
    std::vector<Visit> visits(const Ray& ray) const override;

private:
    void walk(Kd8Walks::Walk how, const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) const {
        if (!how(cells_, contents_.tree(), query, leaves, traversal)) walk_in_doubles(query, leaves, traversal);
    }
    [[gnu::noinline]] void walk_in_doubles(const Bvh8Query& query, Bvh8Leaves& leaves, Traversal& traversal) const;

    Kd8Cells cells_;  // made with the contents
    Bvh8Contents contents_;
    Kd8Walks walks_ = best_kd8_walks();
};

}  // namespace raylab
