// hint: entry_is_no_hit
// Asks a leaf whether there is a hit, and keeps where the leaf is entered.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::function<void(int, double)> visit = [&](int node, double entry) {
        if (nearest && *nearest < entry) return;
        const auto children = tree.children(node);
        if (!children) {
            if (tree.hit(node).has_value()) nearest = entry;
            return;
        }
        const auto [left, right] = *children;
        const auto at_left = tree.entry(left), at_right = tree.entry(right);
        const bool right_first = at_right && (!at_left || *at_right < *at_left);
        if (right_first) visit(right, *at_right);
        if (at_left) visit(left, *at_left);
        if (at_right && !right_first) visit(right, *at_right);
    };
    if (const auto at = tree.entry(0)) visit(0, *at);
    return nearest;
}
