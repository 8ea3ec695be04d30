#pragma once

#include "raylab/accelerator/bound_tree/box_tree.h"
#include "raylab/accelerator/sorted_primitives.h"

namespace raylab {

/// How a tree of boxes is built that may cut what it holds.
struct SpatialSplits {
    double most_duplicates = 1;     // a primitive, over the whole tree
    double least_overlap = 1e-4;    // of two children's boxes, in surface areas of the whole: less is not worth a cut
    std::size_t largest_leaf = 8;
};

/// A tree whose boxes hold what of each primitive lies in a part of space: where a cut between centers would leave two boxes
/// that overlap, and a plane is cheaper, what reaches through the plane is put on both sides, each time with a smaller box. So
/// `order` may name a primitive several times. (M. Stich, H. Friedrich, A. Dietrich, Spatial Splits in Bounding Volume
/// Hierarchies, HPG 2009.)
BoxTree build_tree_with_spatial_splits(const SortedPrimitives& sorted, const SpatialSplits& options = {});

}  // namespace raylab
