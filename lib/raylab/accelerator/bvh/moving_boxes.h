#pragma once

#include "raylab/accelerator/bvh/ray_box.h"
#include "raylab/accelerator/primitives.h"

#include <array>
#include <cstdint>
#include <vector>

// Boxes that move: a node holds its children's boxes at the first and at the last of the rays' times, and a ray tests
// those in between, at its own (Glassner, Spacetime Ray Tracing for Animation, IEEE CG&A 8(2), 1988, has bounds over
// time; Gruenschloss, Stich, Nawaz & Keller, MSBVH: An Efficient Acceleration Data Structure for Ray Traced Motion
// Blur, HPG 2011, interpolate them).

namespace raylab {

/// A ray prepared for tests against moving boxes. It never misses a box about a point that it exactly hits: that moves
/// along a straight line, so that its coordinate is between those of the planes, as far along as the time is.
class MovingBoxRay : public BoxRay {
public:
    MovingBoxRay(const Ray& ray, const Interval<float>& times)
        : BoxRay(ray), share_(times.max > times.min ? since(times.min, ray.time) / since(times.min, times.max) : 0) {}

    using TwoPlanes = std::array<BoxTree::Planes, 2>;

    /// As BoxRay has it.
    std::array<double, 2> entries(const TwoPlanes& planes) const {
        return entries_between([&](std::size_t plane) {
            const Pair first = pair(planes[0][plane]), last = pair(planes[1][plane]);
            const Pair size = (first < 0 ? -first : first) + (last < 0 ? -last : last);
            const Pair between = first * (1 - share_) + last * share_;
            return plane < 3 ? between - room * size : between + room * size;
        });
    }

private:
    // The share errs by three roundings, what is left of one by a fourth, both products and their sum by one each: less
    // than 7 u of either plane.
    static constexpr double room = 16 * unit_roundoff<double>;

    static double since(float begin, float time) { return double{time} - double{begin}; }

    double share_;  // of the rays' times that has passed, from 0 to 1
};

/// Moving boxes as the bounds in a tree's nodes.
struct MovingBoxBounds {
    using One = Box;  // over all times
    struct alignas(64) Node {
        MovingBoxRay::TwoPlanes planes;
        std::array<std::uint32_t, 2> first, count;  // the same fields as in BoxTree::Node
    };
    using PreparedRay = MovingBoxRay;
    static const auto& children(const Node& node) { return node.planes; }
    static Box bound(const Node& node, std::size_t side) {
        return unite(box_of(node.planes[0], side), box_of(node.planes[1], side));
    }
    static std::vector<Node> nodes(const BoxTree& tree, const Primitives& ordered);
};

}  // namespace raylab
