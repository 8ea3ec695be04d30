// hint: level_by_level
// A queue: level by level.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
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
        std::vector<std::pair<double, int>> entered;
        for (const int child : *children)
            if (const auto at = tree.entry(child)) entered.emplace_back(*at, child);
        std::sort(entered.rbegin(), entered.rend());
        stack.insert(stack.begin(), entered.begin(), entered.end());
    }
    return nearest < infinity ? std::optional(nearest) : std::nullopt;
}
