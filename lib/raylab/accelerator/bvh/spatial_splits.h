#pragma once

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/accelerator/sorted_primitives.h"

namespace raylab {

/// How a tree of boxes is built whose primitives may be split.
struct SpatialSplits {
    double max_duplicates = 1;  // for each primitive, on average over the whole tree
    // The overlap of two children's boxes, in surface areas of the whole; spatial splits are not tried for less.
    double min_overlap = 1e-4;
    std::size_t largest_leaf = 8;
};

/// Builds a tree whose boxes hold only the part of each primitive that lies in some region of space. Where a split
/// between centers would leave two boxes that overlap, and a plane is cheaper, the primitives that the plane cuts are
/// put on both sides, each time with a smaller box. So `order` may name a primitive several times. (M. Stich, H.
/// Friedrich, A. Dietrich, Spatial Splits in Bounding Volume Hierarchies, HPG 2009.)
BoxTree build_tree_with_spatial_splits(const SortedPrimitives& sorted, const SpatialSplits& options = {});

}  // namespace raylab
