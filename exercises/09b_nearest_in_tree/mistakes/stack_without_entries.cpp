// hint: asked_twice
// Its stack holds nodes alone, so that it asks for the entry of each one again when it takes it.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::vector<int> stack;
    if (tree.entry(0)) stack.push_back(0);
    while (!stack.empty()) {
        const int node = stack.back();
        stack.pop_back();
        if (const auto entry = tree.entry(node); !entry || *entry > nearest.value_or(*entry)) continue;
        if (const auto children = tree.children(node)) {
            std::vector<std::pair<double, int>> entered;
            for (const int child : *children)
                if (const auto at = tree.entry(child)) entered.emplace_back(*at, child);
            std::sort(entered.rbegin(), entered.rend());
            for (const auto& [at, child] : entered) stack.push_back(child);
        } else if (const auto t = tree.hit(node)) {
            nearest = std::min(*t, nearest.value_or(*t));
        }
    }
    return nearest;
}
