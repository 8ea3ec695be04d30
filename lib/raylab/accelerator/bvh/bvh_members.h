#pragma once

#include "raylab/accelerator/bvh/bvh.h"
#include "raylab/accelerator/bvh/fit_bounds.h"
#include "raylab/accelerator/bvh/packet_walk.h"

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>

// The member functions of Bvh, for the files that instantiate it: bvh.cpp, and tests with bounds of their
// own.

namespace raylab {

namespace bounds_of_nodes {

inline OrientedBox oriented_box(const Slabs& slabs) {
    OrientedBox box{slabs.center, slabs.axes};
    for (int i = 0; i < 3; ++i) box.half_axes[static_cast<std::size_t>(i)] *= slabs.half[i];
    return box;
}

inline Bound as_bound(const Box& box) { return box; }
inline Bound as_bound(const Sphere& sphere) { return sphere; }
inline Bound as_bound(const Slabs& slabs) { return oriented_box(slabs); }

template <class Bounds>
std::vector<typename Bounds::Node> fitted_nodes(const BoxTree& tree, const Primitives& ordered) {
    const auto bounds = fit_bounds<typename Bounds::One>(tree, ordered);
    std::vector<typename Bounds::Node> nodes;
    nodes.reserve(tree.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        nodes.push_back({bounds[i], tree.nodes[i].first, tree.nodes[i].count});
    return nodes;
}

template <class Bounds>
std::vector<typename Bounds::Node> nodes_of(BoxTree& tree, const Primitives& ordered) {
    if constexpr (std::is_same_v<typename Bounds::Node, BoxTree::Node>)
        return std::move(tree.nodes);
    else if constexpr (std::is_same_v<Bounds, MovingBoxBounds>)
        return MovingBoxBounds::nodes(tree, ordered);
    else
        return fitted_nodes<Bounds>(tree, ordered);
}

template <class Bounds>
typename Bounds::PreparedRay prepared(const Ray& ray, const Primitives& primitives) {
    if constexpr (std::is_same_v<Bounds, MovingBoxBounds>)
        return MovingBoxRay(ray, primitives.times());
    else
        return typename Bounds::PreparedRay(ray);
}

}  // namespace bounds_of_nodes

template <class Bounds>
Bvh<Bounds>::Bvh(const Scene& scene, const BoxTreeOptions& options) : Bvh(SortedPrimitives(scene), options) {}

template <class Bounds>
Bvh<Bounds>::Bvh(const SortedPrimitives& sorted, const BoxTreeOptions& options)
    : Bvh(sorted, build_box_tree(sorted.boxes, options)) {}

template <class Bounds>
Bvh<Bounds>::Bvh(const SortedPrimitives& sorted, BoxTree tree)
    : bounded_(sorted.in_order(tree.order)),
      unbounded_(sorted.without_bounds()),
      nodes_(bounds_of_nodes::nodes_of<Bounds>(tree, bounded_)) {}

template <class Bounds>
std::size_t Bvh<Bounds>::bytes() const {
    return nodes_.capacity() * sizeof(Node) + bounded_.bytes() + unbounded_.bytes();
}

template <class Bounds>
template <class AtLeaf, class ComeTo>
void Bvh<Bounds>::walk(const PreparedRay& ray, Traversal& traversal, const AtLeaf& at_leaf,
                       const ComeTo& come_to) const {
    struct Later {
        Child child;
        double entry;
    };
    std::array<Later, BoxTree::max_depth> later;  // at most one sibling waits at each depth
    std::size_t waiting = 0;
    if (nodes_.empty()) return;

    Later next{{0, 0}, 0};
    while (true) {
        const auto [first, count] = next.child;
        come_to(next.child);
        if (count > 0) {
            if (at_leaf(first, first + count)) return;
        } else {
            const Node& node = nodes_[first];
            ++traversal.steps;
            traversal.box_tests += 2;
            const auto [one, other] = ray.entries(Bounds::children(node));
            const std::size_t nearer = other < one ? 1 : 0, farther = 1 - nearer;
            const double entry = std::min(one, other), later_entry = std::max(one, other);
            if (ray.reaches(later_entry)) later[waiting++] = {{node.first[farther], node.count[farther]}, later_entry};
            if (ray.reaches(entry)) {
                next = {{node.first[nearer], node.count[nearer]}, entry};
                continue;
            }
        }
        do {
            if (waiting == 0) return;
            next = later[--waiting];
        } while (!ray.reaches(next.entry));
    }
}

template <class Bounds>
template <class ComeTo>
std::optional<Hit> Bvh<Bounds>::nearest(const Ray& ray, Traversal& traversal, const ComeTo& come_to) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < unbounded_.size(); ++i) unbounded_.test(i, ray, nearest, traversal);
    PreparedRay prepared = bounds_of_nodes::prepared<Bounds>(ray, bounded_);
    prepared.set_end(std::min<double>(ray.range.max, nearest.limit()));
    const auto test = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) bounded_.test(i, ray, nearest, traversal);
        prepared.set_end(std::min<double>(ray.range.max, nearest.limit()));
        return false;
    };
    walk(prepared, traversal, test, come_to);
    return nearest.hit();
}

template <class Bounds>
std::optional<Hit> Bvh<Bounds>::closest(const Ray& ray, Traversal& traversal) const {
    return nearest(ray, traversal, [](Child) {});
}

// Only a tree of boxes is traversed by packets: of consecutive rays, if they go in the same direction along each axis.
template <class Bounds>
std::vector<std::optional<Hit>> Bvh<Bounds>::closest_of(std::span<const Ray> rays, Traversal& traversal) const {
    if constexpr (std::is_same_v<Bounds, BoxBounds>)
        return hits_by_packets(nodes_, bounded_, unbounded_, rays, traversal,
                               [&](const Ray& ray) { return closest(ray, traversal); });
    else
        return Accelerator::closest_of(rays, traversal);
}

template <class Bounds>
bool Bvh<Bounds>::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return bounded_.hits(i, ray, traversal); })) return true;
    for (std::size_t i = 0; i < unbounded_.size(); ++i) {
        if (unbounded_.hits(i, ray, traversal)) return true;
    }
    bool hit = false;
    const auto test = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end && !hit; ++i) {
            hit = bounded_.hits(i, ray, traversal);
            if (hit) traversal.stopped_by(i);
        }
        return hit;
    };
    walk(bounds_of_nodes::prepared<Bounds>(ray, bounded_), traversal, test, [](Child) {});
    return hit;
}

template <class Bounds>
Outline Bvh<Bounds>::outline() const {
    if (nodes_.empty()) return {};
    const std::vector<std::uint32_t> places = bounded_.places();
    Outline outline;
    outline.nodes.push_back({bounds_of_nodes::as_bound(fit_bound<typename Bounds::One>(bounded_))});
    std::vector<Child> waiting{{0, 0}};  // waiting[i] is the child that became node i of the outline
    const std::size_t sides = bounded_.size() == 1 ? 1 : 2;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        const auto [first, count] = waiting[i];
        for (std::uint32_t k = first; k < first + count; ++k) outline.nodes[i].primitives.push_back(places[k]);
        for (std::size_t side = 0; count == 0 && side < sides; ++side) {
            const Node& node = nodes_[first];
            outline.nodes[i].children.push_back(static_cast<std::uint32_t>(outline.nodes.size()));
            outline.nodes.push_back({bounds_of_nodes::as_bound(Bounds::bound(node, side))});
            waiting.push_back({node.first[side], node.count[side]});
        }
    }
    return outline;
}

template <class Bounds>
std::vector<Visit> Bvh<Bounds>::visits(const Ray& ray) const {
    std::map<Child, Bound> bounds;
    if (!nodes_.empty())
        bounds.emplace(Child{0, 0}, bounds_of_nodes::as_bound(fit_bound<typename Bounds::One>(bounded_)));
    for (const Node& node : nodes_)
        for (std::size_t side = 0; side < 2; ++side)
            bounds.emplace(Child{node.first[side], node.count[side]},
                           bounds_of_nodes::as_bound(Bounds::bound(node, side)));
    std::vector<Visit> visits;
    Traversal traversal;
    std::uint64_t before = 0;  // the count of tests before this visit
    const auto count_tests = [&] {
        if (!visits.empty()) visits.back().tests = traversal.primitive_tests - before;
        before = traversal.primitive_tests;
    };
    nearest(ray, traversal, [&](Child child) {
        count_tests();
        visits.push_back({bounds.at(child), child.count > 0 ? Visit::Kind::leaf : Visit::Kind::inner});
    });
    count_tests();
    return visits;
}

}  // namespace raylab
