// hint: root
// or: missed_box
// The root is put on the stack with 0 for its entry, whether the ray enters it or not.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    double nearest = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, int>> stack{{0, 0}};
    while (!stack.empty()) {
        const auto [entry, node] = stack.back();
        stack.pop_back();
        if (entry > nearest) continue;
        const auto children = tree.children(node);
        if (!children) {
            nearest = std::min(nearest, tree.hit(node).value_or(nearest));
            continue;
        }
        const auto before = static_cast<std::ptrdiff_t>(stack.size());
        for (const int child : *children)
            if (const auto at = tree.entry(child)) stack.emplace_back(*at, child);
        std::sort(stack.begin() + before, stack.end(), std::greater<>());
    }
    if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
    return nearest;
}
