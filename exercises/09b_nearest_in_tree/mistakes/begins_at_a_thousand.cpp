// hint: far_away
// or: one_group
// Takes a thousand for farther than anything.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <functional>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    double nearest = 1000;
    const std::function<void(int, double)> open = [&](int node, double entry) {
        if (entry > nearest) return;
        const auto children = tree.children(node);
        if (!children) {
            if (const auto t = tree.hit(node); t && *t < nearest) nearest = *t;
            return;
        }
        const auto [one, other] = *children;
        const auto at_one = tree.entry(one), at_other = tree.entry(other);
        const bool is_other_first = at_one && at_other && *at_other < *at_one;
        if (is_other_first) open(other, *at_other);
        if (at_one) open(one, *at_one);
        if (at_other && !is_other_first) open(other, *at_other);
    };
    if (const auto entry = tree.entry(0)) open(0, *entry);
    if (nearest == 1000) return std::nullopt;
    return nearest;
}
