#pragma once

#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/accelerator/bvh8/triangle_runs.h"
#include "raylab/geometry/bounds/box.h"

#include <span>

namespace raylab {

struct Bvh8BuildOptions {
    // How often primitives may be named again in another leaf, for each primitive on average; 0: none is split.
    double max_duplicates = 0;
    int threads = 1;  // 0: all cores. The tree is the same for any number.
};

/// Splits the primitives in two until there are only leaves, where the surface area heuristic over a few bins for each
/// axis expects the lowest cost (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007), and makes
/// wide nodes of the binary tree's (bvh8_collapse.h). In the top of a large tree, the largest part is split until there
/// are eight. Where duplicates are allowed, and the boxes of two parts would overlap, primitives may be split by a
/// plane instead (bvh8_plane_split.h). It throws an Error for more than 2^27 primitives.
Bvh8Nodes build_bvh8_nodes(const TriangleRuns& triangles, std::span<const Box> others,
                           const Bvh8BuildOptions& options = {});

}  // namespace raylab
