#include "raylab/accelerator/bvh8/bvh8_any_order.h"

#include "raylab/accelerator/bvh8/bvh8_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {

namespace {

using bvh8_parts::area;
using bvh8_parts::Extent;
using bvh8_parts::leaf_work;

Extent extent_of(const Bvh8Node& node, std::size_t place) {
    const auto corner = [&](std::size_t row) {
        return FourFloats{node.planes[row][place], node.planes[row + 1][place], node.planes[row + 2][place], 0};
    };
    return {corner(0), corner(3)};
}

Extent extent_of_all(const Bvh8Node& node) {
    Extent all;
    for (std::size_t place = 0; place < bvh8_width; ++place) all.add(extent_of(node, place));
    return all;
}

// The share of one area in another, at most 1, and 1 where both are zero or infinite.
float share(float part, float whole) {
    const float of_whole = part / whole;
    return of_whole < 1 ? of_whole : 1;
}

constexpr float most_work = 1e30f;  // more would overflow, where many boxes are infinite

AnyHitOrder::Expected expected_of_leaf(const Bvh8Nodes& tree, Bvh8Child child, float half_area) {
    constexpr float stopped_by_other_shapes = 0.5f;
    if (child.kind() == Bvh8Child::Kind::others) return {leaf_work, stopped_by_other_shapes};
    float areas = 0;
    for (std::size_t place = 0; place < child.count(); ++place) areas += area(tree.triangle(child, place));
    return {leaf_work, share(areas, half_area)};
}

}  // namespace

struct AnyHitOrder::Child {
    Expected expected;
    float hit;  // the probability that a line that hits the parent's box hits the child's
    Bvh8Child child;
    std::array<float, 6> planes;

    float work_to_stop() const { return expected.work / expected.stopped; }
};

AnyHitOrder::Expected AnyHitOrder::arranged(const Bvh8Nodes& tree, Bvh8Node& node) const {
    const float all = extent_of_all(node).half_area();
    std::array<Child, bvh8_width> children;
    std::size_t count = 0;
    for (std::size_t place = 0; place < bvh8_width && !node.children[place].is_root(); ++place) {
        Child& one = children[count++];
        one.child = node.children[place];
        for (std::size_t row = 0; row < 6; ++row) one.planes[row] = node.planes[row][place];
        const float own = extent_of(node, place).half_area();
        one.hit = share(own, all);
        one.expected = one.child.is_node() ? nodes_[one.child.first()] : expected_of_leaf(tree, one.child, own);
    }
    // The walk takes the last one first.
    std::stable_sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const Child& a, const Child& b) { return a.work_to_stop() > b.work_to_stop(); });
    float work = 1, goes_on = 1;
    for (std::size_t place = count; place-- > 0;) {
        const Child& one = children[place];
        node.children[place] = one.child;
        for (std::size_t row = 0; row < 6; ++row) node.planes[row][place] = one.planes[row];
        work += goes_on * one.hit * one.expected.work;
        goes_on *= 1 - one.hit * one.expected.stopped;
    }
    return {std::min(work, most_work), 1 - goes_on};
}

AnyHitOrder::Expected AnyHitOrder::arrange(Bvh8Nodes& tree, std::size_t nodes) {
    if (nodes_.size() < nodes) nodes_.resize(nodes);
    for (std::size_t i = nodes; i-- > 0;) nodes_[i] = arranged(tree, tree.nodes[i]);
    return nodes_[0];
}

void AnyHitOrder::know(std::size_t node, Expected expected) {
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    nodes_[node] = expected;
}

}  // namespace raylab
