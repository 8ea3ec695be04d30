// hint: farther_forgotten
// or: first_is_not_nearest
// The hit in a node is taken to be the hit in that child of it which is entered first.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::function<std::optional<double>(int)> hit_in = [&](int node) {
        const auto children = tree.children(node);
        if (!children) return tree.hit(node);
        std::vector<std::pair<double, int>> entered;
        for (const int child : *children)
            if (const auto at = tree.entry(child)) entered.emplace_back(*at, child);
        return entered.empty() ? std::nullopt : hit_in(std::min_element(entered.begin(), entered.end())->second);
    };
    return tree.entry(0) ? hit_in(0) : std::nullopt;
}
