#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/wide/wide_contents.h"
#include "raylab/accelerator/wide/wide_walk.h"

namespace raylab {

/// The lab's default: eight boxes, and eight triangles, tested at once. Triangles at rest are first tested in floats with
/// a bound of their error, and only what that leaves open is asked exactly; any other shape is asked one by one.
class WideTree final : public Accelerator {
public:
    explicit WideTree(const Scene& scene) : contents_(scene) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override { return contents_.bytes(); }
    Outline outline() const override;
    std::vector<Visit> visits(const Ray& ray) const override;

    /// As Pluecker's test in floats has it, through the same boxes: what exactness is measured against, for benchmarks of
    /// meshes only. Nothing for rays that floats cannot hold.
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
