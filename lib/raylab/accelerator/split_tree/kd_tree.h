#pragma once

#include "raylab/accelerator/primitives.h"
#include "raylab/accelerator/split_tree/split_tree.h"

#include <vector>

namespace raylab {

template <Real T>
class SplitRay;

/// A tree of axis-aligned planes: a ray visits the cells along it one after the other, and each cell lists the
/// primitives that reach into it. The rule that places the planes makes it a kd-tree, or the simpler axis-aligned BSP
/// tree.
class KdTree final : public Accelerator {
public:
    explicit KdTree(const Scene& scene, const PlaneRule& rule = surface_area_heuristic());

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;
    Outline outline() const override;
    std::vector<Visit> visits(const Ray& ray) const override;

    /// The size of the tree, for tables: nodes, leaves, the depth of the deepest leaf, and how many entries the leaves
    /// have.
    struct Size {
        std::size_t nodes = 0, leaves = 0, empty_leaves = 0, references = 0, deepest = 0;
    };
    Size size() const;

private:
    KdTree(const SortedPrimitives& sorted, const PlaneRule& rule);

    /// Calls at_leaf(node, end) for the cells that the ray enters before t = end, the nearer one first, until it
    /// returns true, and at_node(index) for every node on the way. at_leaf may lower `end`.
    template <class AtNode, class AtLeaf>
    void visit(const Ray& ray, double end, Traversal& traversal, const AtNode& at_node, const AtLeaf& at_leaf) const;
    template <Real T, class AtNode, class AtLeaf>
    void walk(const SplitRay<T>& ray, double end, Traversal& traversal, const AtNode& at_node,
              const AtLeaf& at_leaf) const;

    template <class AtNode>
    std::optional<Hit> closest(const Ray& ray, Traversal& traversal, const AtNode& at_node) const;

    std::vector<Box> cells() const;  // the cells of all nodes

    SplitTree tree_;  // its parts are numbered as they lie in bounded_: by the first leaf that holds them
    Primitives bounded_, unbounded_;
};

}  // namespace raylab
