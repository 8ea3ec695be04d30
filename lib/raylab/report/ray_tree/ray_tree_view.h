#pragma once

#include "raylab/tracer/whitted/ray_tree.h"

#include <optional>

// Chooses the part of a ray tree that is drawn: a tree of depth 10 has a thousand rays, of which a few dozen determine
// the pixel.

namespace raylab {

struct RayTreeView {
    // A branch is drawn only if its throughput is greater; absent: the heaviest are drawn.
    std::optional<double> prune = {};
    std::size_t largest = 40;  // ... and this is the number of rays
    enum class ShadowRays { hidden, shown } shadow_rays = ShadowRays::hidden;
    std::vector<std::size_t> marked = {};  // these nodes are always drawn, with all rays on the way to them
};

/// The sum of the branches under one node that are not drawn.
struct PrunedBranches {
    std::size_t parent;
    std::size_t rays = 0;         // without cut branches and shadow rays
    double throughput = 0;        // the sum of the branches' throughputs
    Color contribution{0, 0, 0};  // the sum of what they add to the pixel
};

struct ShownTree {
    std::vector<std::size_t> nodes;  // indices, parents before children
    std::vector<PrunedBranches> pruned;
    std::vector<Color> brought;  // for every node of the tree, the colour that its ray returns
};

ShownTree shown_tree(const RayTree& tree, const RayTreeView& view);

}  // namespace raylab
