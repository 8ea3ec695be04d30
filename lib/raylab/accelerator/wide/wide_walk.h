#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/wide/wide_node.h"
#include "raylab/accelerator/wide/wide_ray.h"

#include <cstddef>
#include <limits>
#include <optional>

namespace raylab {

/// What a walk asks about where floats cannot tell, or a hit is likely. Each answers with the t beyond which nothing matters
/// any more: less than any t, and the walk ends.
class WideLeaves {
public:
    virtual ~WideLeaves() = default;
    virtual double triangle(WideChild leaf, std::size_t place) = 0;
    virtual double others(WideChild leaf) = 0;

    static constexpr double nothing_more = -std::numeric_limits<double>::infinity();
};

/// Walks through the boxes that the ray meets, the nearest child first, with the best instruction set of this machine. The
/// ray is tame.
void walk(const WideNodes& tree, WideRay& ray, WideLeaves& leaves, Traversal& traversal);

struct WideHit {
    WideChild leaf;
    std::size_t place;
    float t;
};

/// The same walk, Pluecker's test in floats deciding alone about triangles: what exactness is measured against.
std::optional<WideHit> plain_walk(const WideNodes& tree, WideRay& ray, WideLeaves& leaves, Traversal& traversal);

}  // namespace raylab
