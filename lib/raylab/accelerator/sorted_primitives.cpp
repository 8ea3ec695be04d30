#include "raylab/accelerator/sorted_primitives.h"

namespace raylab {

SortedPrimitives::SortedPrimitives(const Scene& scene) : all(scene) {
    bounded.reserve(all.size());
    boxes.reserve(all.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const auto box = all.bounds(i);
        (box ? bounded : unbounded).push_back(i);
        if (box) boxes.push_back(*box);
    }
}

Primitives SortedPrimitives::in_order(std::vector<std::uint32_t> order) const {
    for (std::uint32_t& i : order) i = bounded[i];
    return Primitives(all, order);
}

}  // namespace raylab
