// hint: order
// Searches the left child, and the right one with what was found in the left.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <cmath>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::function<double(int, double, double)> nearer = [&](int node, double entry, double limit) {
        if (entry >= limit) return limit;
        const auto children = tree.children(node);
        if (!children) return std::min(limit, tree.hit(node).value_or(limit));
        const double left = tree.entry((*children)[0]).value_or(HUGE_VAL);
        const double right = tree.entry((*children)[1]).value_or(HUGE_VAL);
        limit = nearer((*children)[0], left, limit);
        return nearer((*children)[1], right, limit);
    };
    const auto at = tree.entry(0);
    const double t = at ? nearer(0, *at, HUGE_VAL) : HUGE_VAL;
    return t < HUGE_VAL ? std::optional(t) : std::nullopt;
}
