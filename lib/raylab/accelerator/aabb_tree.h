#pragma once

#include "raylab/accelerator/box_tree.h"
#include "raylab/accelerator/primitives.h"

#include <vector>

namespace raylab {

class BoxRay;
struct SortedPrimitives;

/// A binary tree of axis-aligned boxes over the bounded primitives; the others (planes) stay in a list beside it.
class AabbTree final : public Accelerator {
public:
    explicit AabbTree(const Scene& scene);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;

private:
    explicit AabbTree(const SortedPrimitives& sorted);
    AabbTree(const SortedPrimitives& sorted, BoxTree tree);

    /// Calls at_leaf(first, end) for the leaves whose boxes the ray meets, the nearer child first, until it returns true.
    template <class AtLeaf>
    void visit(const BoxRay& ray, Traversal& traversal, const AtLeaf& at_leaf) const;

    std::vector<BoxTree::Node> nodes_;
    Primitives bounded_, unbounded_;
};

}  // namespace raylab
