#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/wide/wide_node.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace raylab {

/// What a walk asks about where floats cannot tell, or which hit is the nearest. Each answers with the t beyond which nothing matters
/// any more: less than any t, and the walk ends.
class WideLeaves {
public:
    virtual ~WideLeaves() = default;
    virtual double triangle(WideChild leaf, std::size_t place) = 0;
    virtual double sure(WideChild leaf, std::size_t place) = 0;  // surely hit, where any hit will do
    virtual double others(WideChild leaf) = 0;

    static constexpr double nothing_more = -std::numeric_limits<double>::infinity();
};

/// A ray's question to a tree.
struct WideQuery {
    const Ray& ray;
    double end;             // nothing beyond this t matters
    std::uint32_t leaving;  // the number of the triangle that the ray leaves, or leaves_none
    enum class Question { nearest, any } question;

    static constexpr std::uint32_t leaves_none = 0xffffffff;
};

/// Walks through the boxes that the ray meets, the nearest child first, with the best instruction set of this machine.
/// False: the ray is not one for floats (beyond 2^60, steeper or flatter than they can divide by, behind its origin), nothing
/// has been asked.
bool walk(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal);

struct WideHit {
    WideChild leaf;
    std::size_t place;
    float t;
};

/// The same walk, Pluecker's test in floats deciding alone about triangles: what exactness is measured against.
std::optional<WideHit> plain_walk(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal);

}  // namespace raylab
