#pragma once

#include "raylab/accelerator/octree/octree_cells.h"
#include "raylab/accelerator/octree/octree_hash_table.h"
#include "raylab/accelerator/octree/octree_parametric.h"
#include "raylab/accelerator/octree/octree_point_search.h"
#include "raylab/accelerator/octree/octree_seads.h"
#include "raylab/accelerator/primitives.h"

namespace raylab {

struct SortedPrimitives;

/// An octree over the primitives' boxes; `Way` is the algorithm that finds the next cell. Primitives without bounds, or
/// with bounds that reach to infinity, stay in a list beside it.
template <class Way>
class OctreeBy final : public Accelerator {
public:
    explicit OctreeBy(const Scene& scene);
    OctreeBy(const Scene& scene, const OctreeLimits& limits);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;

    Outline outline() const override;

    /// The leaves along the ray; the cells through which they were found are only counted as steps.
    std::vector<Visit> visits(const Ray& ray) const override;

private:
    struct Parts;
    explicit OctreeBy(Parts parts);

    /// closest(), which also passes each leaf and the tests it took to `record`.
    template <class Record>
    std::optional<Hit> trace(const Ray& ray, Traversal& traversal, const Record& record) const;

    Lattice lattice_;
    OctreeCells tree_;  // its references are indices of bounded_
    Way way_;
    Primitives bounded_, unbounded_;
};

using Octree = OctreeBy<Parametric>;
using OctreePoint = OctreeBy<PointSearch>;
using OctreeHash = OctreeBy<HashTable>;
using OctreeSeads = OctreeBy<Seads>;

}  // namespace raylab
