#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/wide/wide_contents.h"
#include "raylab/accelerator/wide/wide_walk.h"

namespace raylab {

/// The default structure: eight boxes, and eight triangles, are tested at once. Triangles that are not transformed are
/// first tested in floats with an error bound, and only those that this leaves open are tested exactly; other shapes
/// are tested one by one.
class WideTree final : public Accelerator {
public:
    explicit WideTree(const Scene& scene) : contents_(scene) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override { return contents_.bytes(); }
    Outline outline() const override;
    std::vector<Visit> visits(const Ray& ray) const override;

    /// The nearest hit by Pluecker's test in floats, through the same boxes. It is for benchmarks of meshes only, which
    /// compare the exact answer with it. It finds nothing for rays whose numbers exceed the limits of WideRay.
    std::optional<Hit> closest_in_floats(const Ray& ray, Traversal& traversal) const;

private:
    void walk(WideWalks::Walk how, const WideQuery& query, WideLeaves& leaves, Traversal& traversal) const {
        if (!how(contents_.tree(), query, leaves, traversal)) walk_in_doubles(query, leaves, traversal);
    }
    [[gnu::noinline]] void walk_in_doubles(const WideQuery& query, WideLeaves& leaves, Traversal& traversal) const;

    WideContents contents_;
    WideWalks walks_ = best_wide_walks();
};

}  // namespace raylab
