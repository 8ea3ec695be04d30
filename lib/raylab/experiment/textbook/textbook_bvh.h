#pragma once

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/accelerator/sorted_primitives.h"

namespace raylab {

/// A tree of boxes as textbooks traverse it: by nearest_in_tree() and box_entry(), in doubles and without any error
/// bound. It is for experiments: where rounding makes a ray pass a box by, it misses what is in it.
class TextbookBvh final : public Accelerator {
public:
    explicit TextbookBvh(const Scene& scene);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override { return closest(ray, traversal).has_value(); }
    std::size_t bytes() const override;

private:
    explicit TextbookBvh(const SortedPrimitives& sorted);

    BoxTree tree_;
    Primitives bounded_, unbounded_;
    Box all_;
};

}  // namespace raylab
