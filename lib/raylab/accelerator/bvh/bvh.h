#pragma once

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/accelerator/bvh/moving_boxes.h"
#include "raylab/accelerator/bvh/ray_box.h"
#include "raylab/accelerator/bvh/ray_slabs.h"
#include "raylab/accelerator/bvh/ray_sphere_bound.h"
#include "raylab/accelerator/primitives.h"
#include "raylab/accelerator/sorted_primitives.h"

#include <array>
#include <span>
#include <vector>

namespace raylab {

/// Boxes as the bounds in a tree's nodes: a node holds the bounds of its two children, and a ray prepared for them
/// tests both at once.
struct BoxBounds {
    using One = Box;
    using Node = BoxTree::Node;
    using PreparedRay = BoxRay;
    static const auto& children(const Node& node) { return node.planes; }
    static Box bound(const Node& node, std::size_t side) { return box_of(node.planes, side); }
};

template <class OneOfThem, class RayOfBounds>
struct FittedBounds {
    using One = OneOfThem;
    struct Node {
        std::array<One, 2> bounds;
        std::array<std::uint32_t, 2> first, count;  // the same fields as in BoxTree::Node
    };
    using PreparedRay = RayOfBounds;
    static const auto& children(const Node& node) { return node.bounds; }
    static One bound(const Node& node, std::size_t side) { return node.bounds[side]; }
};
using SphereBounds = FittedBounds<Sphere, SphereBoundRay>;
using SlabBounds = FittedBounds<Slabs, SlabsRay>;

/// A binary tree of bounding volumes (BVH) over the bounded primitives; the unbounded ones (planes) stay in a list
/// beside it. For every kind of bound the tree has the topology that is built over the primitives' boxes: only how
/// tightly a node encloses its primitives differs.
template <class Bounds>
class Bvh final : public Accelerator {
public:
    explicit Bvh(const Scene& scene, const BoxTreeOptions& options = {});
    // Takes a tree over these boxes that was built in another way; it may name a primitive several times.
    Bvh(const SortedPrimitives& sorted, BoxTree tree);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::vector<std::optional<Hit>> closest_of(std::span<const Ray> rays, Traversal& traversal) const override;
    std::size_t bytes() const override;
    Outline outline() const override;
    std::vector<Visit> visits(const Ray& ray) const override;

private:
    using Node = typename Bounds::Node;
    using PreparedRay = typename Bounds::PreparedRay;
    struct Child {  // a child as its parent stores it
        std::uint32_t first, count;
        friend auto operator<=>(const Child&, const Child&) = default;
    };

    Bvh(const SortedPrimitives& sorted, const BoxTreeOptions& options);

    /// Calls at_leaf(first, end) for the leaves whose bounds the ray hits, the nearer child first, until it returns
    /// true, and come_to(child) for every node and leaf that is visited.
    template <class AtLeaf, class ComeTo>
    void walk(const PreparedRay& ray, Traversal& traversal, const AtLeaf& at_leaf, const ComeTo& come_to) const;
    template <class ComeTo>
    std::optional<Hit> nearest(const Ray& ray, Traversal& traversal, const ComeTo& come_to) const;

    Primitives bounded_, unbounded_;
    std::vector<Node> nodes_;
};

using BoxBvh = Bvh<BoxBounds>;
using SphereBvh = Bvh<SphereBounds>;
using SlabBvh = Bvh<SlabBounds>;
using MovingBvh = Bvh<MovingBoxBounds>;

extern template class Bvh<BoxBounds>;
extern template class Bvh<SphereBounds>;
extern template class Bvh<SlabBounds>;
extern template class Bvh<MovingBoxBounds>;

}  // namespace raylab
