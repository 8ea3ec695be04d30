#include "raylab/radiosity/hierarchy/element_tree.h"

#include <limits>

namespace raylab {

ElementTree::ElementTree(const PatchMesh& mesh, double smallest) : roots_(mesh.patches.size()), smallest_(smallest) {
    for (std::uint32_t i = 0; i < roots_; ++i) elements_.push_back({mesh.patches[i], i, i, i});
}

bool ElementTree::can_be_quartered(std::size_t element) const {
    const Element& one = elements_[element];
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max() / 8;  // 29 levels below one root
    return !one.is_leaf() || (longest_side(one.patch) / 2 >= smallest_ && one.number < most);
}

std::uint32_t ElementTree::quartered(std::uint32_t element) {
    if (elements_[element].is_leaf()) {
        const auto first = static_cast<std::uint32_t>(elements_.size());
        const std::uint32_t root = elements_[element].root;
        std::uint64_t number = roots_ + 4 * elements_[element].number;
        for (const Patch& patch : quarters(elements_[element].patch))
            elements_.push_back({patch, root, element, number++});
        elements_[element].first_child = first;
    }
    return elements_[element].first_child;
}

}  // namespace raylab
