// hint: pruned_the_wrong_way
// Takes a node from the stack, and skips it where it is entered before the nearest hit so far.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::vector<std::pair<double, int>> stack;
    if (const auto at = tree.entry(0)) stack.emplace_back(*at, 0);
    while (!stack.empty()) {
        const auto [entry, node] = stack.back();
        stack.pop_back();
        if (nearest.value_or(entry) > entry) continue;
        const auto children = tree.children(node);
        if (!children) {
            if (const auto t = tree.hit(node)) nearest = std::min(*t, nearest.value_or(*t));
            continue;
        }
        std::vector<std::pair<double, int>> entered;
        for (const int child : *children)
            if (const auto at = tree.entry(child)) entered.emplace_back(*at, child);
        std::sort(entered.rbegin(), entered.rend());
        stack.insert(stack.end(), entered.begin(), entered.end());
    }
    return nearest;
}
