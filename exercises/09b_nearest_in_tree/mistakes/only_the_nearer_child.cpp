// hint: farther_forgotten
// or: first_is_not_nearest
// Goes down through the nearer child, and never back.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    auto at = tree.entry(0);
    if (!at) return std::nullopt;
    int node = 0;
    while (const auto children = tree.children(node)) {
        const auto [left, right] = *children;
        const auto at_left = tree.entry(left), at_right = tree.entry(right);
        if (!at_left && !at_right) return std::nullopt;
        node = at_left && (!at_right || *at_left <= *at_right) ? left : right;
    }
    return tree.hit(node);
}
