#pragma once

#include "raylab/accelerator/bvh8/bvh8_node.h"

#include <cstddef>
#include <vector>

namespace raylab {

/// Orders the children of nodes for rays that ask for any hit: such a ray visits first the child that stops it soonest
/// for its work. (J.-H. Nah and D. Manocha, SATO: Surface Area Traversal Order for Shadow Ray Tracing, Computer
/// Graphics Forum 33(6), 2014.) Rays that ask for the nearest hit sort children themselves.
///
/// If one of several children is visited after the other until one stops the ray, the expected work is least in the
/// order of work / probability that it stops the ray. For a random line that hits a node's box, a child's box is hit
/// with the probability of their surface areas' ratio, and a triangle in a leaf's box with that of its area to half the
/// box's surface area (Cauchy: the mean projected area of a convex body is a quarter of its surface area).
class AnyHitOrder {
public:
    /// What is expected of a random line that hits a node's box: its work until it is stopped, in visits of nodes, and
    /// the probability that it is stopped.
    struct Expected {
        float work, stopped;
    };

    /// Orders the children of the first nodes, which are followed by their children. What is expected of nodes beyond
    /// them must be known. Returns what is expected of the root.
    Expected arrange(Bvh8Nodes& tree, std::size_t nodes);

    void know(std::size_t node, Expected expected);

private:
    struct Child;

    Expected arranged(const Bvh8Nodes& tree, Bvh8Node& node) const;

    std::vector<Expected> nodes_;
};

}  // namespace raylab
