#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/wide/wide_node.h"
#include "raylab/geometry/intersect.h"
#include "raylab/number/arithmetic_probe.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace raylab {

/// A hit of the triangle at a place of a leaf, with bounds of its t.
struct WideHit {
    WideChild leaf;
    std::uint32_t place;
    float soonest, latest;
};

/// What a walk asks where floats cannot tell. Each answers with a t beyond which nothing matters any more:
/// nothing_more, and the walk ends.
class WideLeaves {
public:
    virtual ~WideLeaves() = default;
    virtual double doubtful(WideChild leaf, std::size_t place) = 0;  // a triangle that may be hit, or the nearest
    virtual double met(WideChild leaf, std::size_t place) = 0;       // ... that is hit, where any hit will do
    virtual double others(WideChild leaf) = 0;

    virtual void came_to(WideChild) {}  // told by the walk that tells

    std::optional<WideHit> nearest = {};  // of the hits that the walk has not asked about
    std::optional<Candidate> at = {};     // ... where it is, once the walk has ended, if doubles know it well enough

    static constexpr double nothing_more = -std::numeric_limits<double>::infinity();
};

/// A ray's question to a tree.
struct WideQuery {
    const Ray& ray;
    double end;             // nothing beyond this t matters
    std::uint32_t leaving;  // the number of the triangle that the ray leaves, or leaves_none

    static constexpr std::uint32_t leaves_none = 0xffffffff;
};

/// Walks through the boxes that a ray meets, the nearest child first, compiled for one instruction set.
struct WideWalks {
    /// False: the ray is not one for floats (farther than 2^39, flatter or steeper than they can divide by, behind its
    /// origin), and nothing has been asked.
    using Walk = bool (*)(const WideNodes&, const WideQuery&, WideLeaves&, Traversal&);
    Walk nearest, any;
    Walk nearest_told;  // tells the leaves each node and leaf it comes to

    /// Pluecker's test in floats decides alone about triangles: what exactness is measured against. For rays that
    /// floats can hold, and triangles only.
    Walk plain;

    CompiledFaults (*faults)();  // of this instruction set's code
};

/// For the best instruction set of this machine.
WideWalks best_wide_walks();

}  // namespace raylab
