#pragma once

#include "raylab/tracer/ray_tree.h"

#include <optional>

// What of a ray tree is drawn: a tree of depth 10 has a thousand rays, of which a few dozen make the pixel.

namespace raylab {

struct RayTreeView {
    std::optional<double> prune = {};  // a branch whose weight is not above it is not drawn; absent: the heaviest are
    std::size_t most = 40;             // ... this many rays
    enum class Feelers { hidden, shown } feelers = Feelers::hidden;
    std::vector<std::size_t> marked = {};  // these are drawn in any case, and all rays on the way to them
};

/// The branches under one node that are not drawn, together.
struct PrunedBranches {
    std::size_t parent;
    std::size_t rays = 0;         // cut branches and feelers are none
    double weight = 0;            // the sum of the branches' weights
    Color contribution{0, 0, 0};  // what they add to the pixel
};

struct ShownTree {
    std::vector<std::size_t> nodes;  // indices, parents before children
    std::vector<PrunedBranches> pruned;
    std::vector<Color> brought;  // of every node of the tree: the colour that comes along its ray
};

ShownTree shown_tree(const RayTree& tree, const RayTreeView& view);

}  // namespace raylab
