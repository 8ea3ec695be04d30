#include "raylab/accelerator/sorted_primitives.h"

namespace raylab {

SortedPrimitives::SortedPrimitives(const Scene& scene, int threads) : all(scene) {
    const auto found = bounds_of(scene, all.primitives(), threads);
    bounded.reserve(all.size());
    boxes.reserve(all.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        (found[i] ? bounded : unbounded).push_back(i);
        if (found[i]) boxes.push_back(*found[i]);
    }
}

Primitives SortedPrimitives::in_order(std::vector<std::uint32_t> order) const {
    for (std::uint32_t& i : order) i = bounded[i];
    return Primitives(all, order);
}

}  // namespace raylab
