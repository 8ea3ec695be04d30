#pragma once

#include "raylab/accelerator/four_boxes.h"
#include "raylab/accelerator/primitives.h"

#include <vector>

namespace raylab {

/// For a handful of primitives: a list, but four boxes at a time are looked at before what is in them.
class BoxedList final : public Accelerator {
public:
    explicit BoxedList(const Scene& scene);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override { return primitives_.bytes() + boxes_.capacity() * sizeof(FourBoxes); }

private:
    /// Calls at(i) for the primitives whose boxes the ray meets, in scene order, until it returns true.
    template <class At>
    void visit(const FourBoxesRay& ray, Traversal& traversal, const At& at) const;

    Primitives primitives_;
    std::vector<FourBoxes> boxes_;
};

}  // namespace raylab
