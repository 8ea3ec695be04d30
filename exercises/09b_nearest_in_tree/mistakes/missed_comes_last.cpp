// hint: missed_box
// A box that is missed is opened after the other one.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::function<void(int, double)> visit = [&](int node, double entry) {
        if (nearest && entry > *nearest) return;
        const auto children = tree.children(node);
        if (!children) {
            const auto t = tree.hit(node);
            if (t && (!nearest || *t < *nearest)) nearest = t;
            return;
        }
        const auto [left, right] = *children;
        const auto at_left = tree.entry(left), at_right = tree.entry(right);
        const double to_left = at_left.value_or(1e6), to_right = at_right.value_or(1e6);
        visit(to_left <= to_right ? left : right, std::min(to_left, to_right));
        visit(to_left <= to_right ? right : left, std::max(to_left, to_right));
    };
    if (const auto at = tree.entry(0)) visit(0, *at);
    return nearest;
}
