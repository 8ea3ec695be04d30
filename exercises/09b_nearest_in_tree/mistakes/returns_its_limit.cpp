// hint: none_is_no_number
// or: nothing_there, infinite
// The limit of the search is the answer, and it is still infinite where no leaf has a hit.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <cmath>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    const auto root = tree.entry(0);
    if (!root) return std::nullopt;
    double limit = HUGE_VAL;
    std::vector<std::pair<double, int>> waiting{{*root, 0}};
    while (!waiting.empty()) {
        const auto [entry, node] = waiting.back();
        waiting.pop_back();
        if (entry >= limit) continue;
        if (const auto children = tree.children(node)) {
            const auto [left, right] = *children;
            const auto at_left = tree.entry(left), at_right = tree.entry(right);
            const bool right_first = at_left && at_right && *at_right < *at_left;
            if (right_first) waiting.emplace_back(*at_left, left);
            if (at_right) waiting.emplace_back(*at_right, right);
            if (at_left && !right_first) waiting.emplace_back(*at_left, left);
        } else if (const auto t = tree.hit(node); t && *t < limit) {
            limit = *t;
        }
    }
    return limit;
}
