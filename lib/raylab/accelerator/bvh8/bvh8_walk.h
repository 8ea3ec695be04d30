#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/number/arithmetic_probe.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace raylab {

class Bvh8Contents;

/// A hit of the triangle at a place of a leaf, with bounds of its t.
struct Bvh8Hit {
    Bvh8Child leaf;
    std::uint32_t place;
    float soonest, latest;
};

/// Where on a triangle a hit is, as far as doubles determine it.
struct Bvh8Place {
    double t, u, v;
    bool is_accurate;  // t is what intersect() says, to the bit
};

/// The tests that a traversal delegates where floats cannot decide. Each returns the t at which the ray ends from now
/// on; nothing_more ends the traversal.
class Bvh8Leaves {
public:
    virtual ~Bvh8Leaves() = default;
    // A triangle that may be hit, or may be the nearest.
    virtual double uncertain(Bvh8Child leaf, std::size_t place) = 0;
    virtual double hit_found(Bvh8Child leaf, std::size_t place) = 0;  // a triangle that is hit, where any hit will do
    virtual double others(Bvh8Child leaf) = 0;

    virtual void came_to(Bvh8Child) {}  // called for each node and leaf, by the traversals that report them

    std::optional<Bvh8Hit> nearest = {};  // of the hits that the traversal decided itself
    Bvh8Place at;                         // its place, where there is one and the traversal has ended

    static constexpr double nothing_more = -std::numeric_limits<double>::infinity();
};

/// The query of a ray to a tree.
struct Bvh8Query {
    const Ray& ray;
    double end;              // the ray ends at this t
    std::uint32_t leaving;   // the number of the triangle that the ray leaves, or leaves_none
    float displacement = 0;  // for candidates: on no axis is the ray farther than this from the one that is meant

    static constexpr std::uint32_t leaves_none = 0xffffffff;
};

/// Rays whose traversals take turns: so many are under way at once, each at a place that the next ray takes over.
class Bvh8Turns {
public:
    static constexpr std::size_t under_way = 8;
    struct Asked {
        Bvh8Query query;
        Bvh8Leaves& leaves;
    };

    virtual ~Bvh8Turns() = default;
    virtual const Asked* next(std::size_t place) = 0;    // the next ray, at this place; null: there are no more
    virtual void ended(std::size_t place) = 0;           // its traversal
    virtual void exceeds_floats(std::size_t place) = 0;  // instead: nothing has been tested
};

/// Traversals through the boxes that a ray hits, the nearest child first, and the answers that they give, compiled for
/// one instruction set.
struct Bvh8Walks {
    /// The answers to a ray, as of every Accelerator.
    std::optional<Hit> (*closest)(const Bvh8Contents&, const Ray&, Traversal&);
    bool (*occluded)(const Bvh8Contents&, const Ray&, Traversal&);

    /// The nearest hit by Pluecker's test in floats alone, for comparison with the exact answer. It is for triangles
    /// only, and finds nothing for rays for which floats do not suffice.
    std::optional<Hit> (*closest_in_floats)(const Bvh8Contents&, const Ray&, Traversal&);

    /// False where floats do not suffice for the ray (it starts farther away than 2^39, its direction is too small or
    /// too large to divide by, or its range begins behind its origin); then nothing has been tested.
    using Walk = bool (*)(const Bvh8Nodes&, const Bvh8Query&, Bvh8Leaves&, Traversal&);
    Walk nearest_told;  // the nearest hit's, which reports each node and leaf that it visits

    /// Decides nothing: passes on each triangle that a ray within the displacement may hit, at any t.
    Walk candidates;
    /// The same until any is hit; hit_found() is told of one that each ray within the displacement hits in its range.
    Walk any_candidate;

    /// The nearest hits, or any, of several rays. One that comes to a node or leaf beyond the first `near_bytes` of all
    /// nodes, or of all leaves, has to wait for memory, and the next one goes on. The tree has nodes.
    using WalkInTurns = void (*)(const Bvh8Nodes&, std::size_t near_bytes, Bvh8Turns&, Traversal&);
    WalkInTurns nearest_in_turns, any_in_turns;

    CompiledFaults (*faults)();  // of the code for this instruction set
};

/// The traversals for the best instruction set of this machine.
Bvh8Walks best_bvh8_walks();

}  // namespace raylab
