#pragma once

#include "raylab/accelerator/bvh8/triangle_runs.h"
#include "raylab/accelerator/kd8/kd8_node.h"
#include "raylab/accelerator/split_tree/plane_rule.h"
#include "raylab/geometry/bounds/box.h"

#include <span>

namespace raylab {

/// The cells of a kd-tree, and apart from them what lies in its leaves, as bvh8 has it; that has no nodes.
struct Kd8Tree {
    Kd8Cells cells;
    Bvh8Nodes contents;
};

/// Builds a kd-tree as the rule says, and puts three of its levels into each node. It throws an Error for more than 2
/// GiB of leaves.
Kd8Tree build_kd8(const TriangleRuns& triangles, std::span<const Box> others, const PlaneRule& rule);

}  // namespace raylab
