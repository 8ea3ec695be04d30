#pragma once

#include "raylab/accelerator/octree/octree_cells.h"
#include "raylab/accelerator/octree/point_in_next_cell.h"
#include "raylab/accelerator/primitives.h"

#include <functional>

namespace raylab {

/// The t at which a ray leaves a cube.
double exit_of(const OctreeCube& cube, const Vec3d& origin, const Vec3d& direction);

/// An octree as textbooks traverse it: from point to point, each looked up from the root, without any error bound. It
/// is for experiments: where rounding makes the next point a wrong one, it misses hits.
class TextbookOctree final : public Accelerator {
public:
    /// How the traversal goes on: from a leaf to a point in the next one, in units of the lattice's cells.
    using NextPoint =
        std::function<Vec3d(const OctreeCube& leaf, double smallest, const Vec3d& origin, const Vec3d& direction)>;
    enum class End { at_hit_in_leaf, at_first_hit };

    explicit TextbookOctree(const Scene& scene, const NextPoint& next_point = point_in_next_cell,
                            End end = End::at_hit_in_leaf);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override { return closest(ray, traversal).has_value(); }
    std::size_t bytes() const override;

private:
    struct Leaf {
        OctreeCell cell;
        OctreeCube cube;
    };
    std::optional<Leaf> leaf_at(const Vec3d& point, Traversal& traversal) const;  // absent outside the root

    static constexpr int depth_ = 10;
    static constexpr double smallest_ = 1 << (Lattice::bits - depth_);

    Primitives primitives_;
    Lattice lattice_;
    OctreeCells tree_;
    NextPoint next_point_;
    End end_;
};

}  // namespace raylab
