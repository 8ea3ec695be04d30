// hint: asked_twice
// Asks for both boxes again to compare them.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double nearest = infinity;
    std::vector<std::pair<double, int>> stack;
    if (const auto at = tree.entry(0)) stack.emplace_back(*at, 0);
    while (!stack.empty()) {
        const auto [entry, node] = stack.back();
        stack.pop_back();
        if (entry > nearest) continue;
        const auto children = tree.children(node);
        if (!children) {
            if (const auto t = tree.hit(node); t && *t < nearest) nearest = *t;
            continue;
        }
        for (const int child : *children)
            if (const auto at = tree.entry(child)) stack.emplace_back(*at, child);
        if (tree.entry((*children)[0]) && tree.entry((*children)[1]))
            std::sort(stack.end() - 2, stack.end(), std::greater<>());
    }
    return nearest < infinity ? std::optional(nearest) : std::nullopt;
}
