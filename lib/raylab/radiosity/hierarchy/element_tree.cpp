#include "raylab/radiosity/hierarchy/element_tree.h"

namespace raylab {

ElementTree::ElementTree(const PatchMesh& mesh, double smallest) : roots_(mesh.patches.size()), smallest_(smallest) {
    for (std::uint32_t i = 0; i < roots_; ++i) elements_.push_back({mesh.patches[i], i, i});
}

bool ElementTree::can_be_quartered(std::size_t element) const {
    const Element& one = elements_[element];
    return !one.is_leaf() || longest_side(one.patch) / 2 >= smallest_;
}

std::uint32_t ElementTree::quartered(std::uint32_t element) {
    if (elements_[element].is_leaf()) {
        const auto first = static_cast<std::uint32_t>(elements_.size());
        const std::uint32_t root = elements_[element].root;
        for (const Patch& patch : quarters(elements_[element].patch)) elements_.push_back({patch, root, element});
        elements_[element].first_child = first;
    }
    return elements_[element].first_child;
}

}  // namespace raylab
