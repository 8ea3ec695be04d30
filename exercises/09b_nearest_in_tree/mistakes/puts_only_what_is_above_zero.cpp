// hint: entry_of_zero
// or: missed_box
// Marks a missed box by the entry 0, and so leaves out each box in which the ray begins.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    double nearest = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, int>> stack;
    const auto put = [&](double entry, int node) {
        if (entry != 0) stack.emplace_back(entry, node);
    };
    put(tree.entry(0).value_or(0), 0);
    while (!stack.empty()) {
        const auto [entry, node] = stack.back();
        stack.pop_back();
        if (entry > nearest) continue;
        if (const auto children = tree.children(node)) {
            const auto [left, right] = *children;
            const double at_left = tree.entry(left).value_or(0), at_right = tree.entry(right).value_or(0);
            const bool right_first = at_right < at_left;
            put(std::max(at_left, at_right), right_first ? left : right);
            put(std::min(at_left, at_right), right_first ? right : left);
        } else {
            nearest = std::min(nearest, tree.hit(node).value_or(nearest));
        }
    }
    return nearest < std::numeric_limits<double>::infinity() ? std::optional(nearest) : std::nullopt;
}
