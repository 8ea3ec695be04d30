// hint: order
// The left child is always the first.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

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
        const auto [left, right] = *children;
        if (const auto at = tree.entry(right)) stack.emplace_back(*at, right);
        if (const auto at = tree.entry(left)) stack.emplace_back(*at, left);
    }
    return nearest < infinity ? std::optional(nearest) : std::nullopt;
}
