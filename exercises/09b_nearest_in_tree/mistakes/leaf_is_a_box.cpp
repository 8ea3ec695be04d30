// hint: entry_is_no_hit
// A leaf gives the t at which its box is entered, and what lies in it is not asked.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <cmath>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::function<double(int, double, double)> nearer = [&](int node, double entry, double limit) {
        if (entry >= limit) return limit;
        const auto children = tree.children(node);
        if (!children) return entry;
        const double left = tree.entry((*children)[0]).value_or(HUGE_VAL);
        const double right = tree.entry((*children)[1]).value_or(HUGE_VAL);
        const std::size_t first = left <= right ? 0 : 1;
        limit = nearer((*children)[first], std::min(left, right), limit);
        return nearer((*children)[1 - first], std::max(left, right), limit);
    };
    const auto at = tree.entry(0);
    const double t = at ? nearer(0, *at, HUGE_VAL) : HUGE_VAL;
    return t < HUGE_VAL ? std::optional(t) : std::nullopt;
}
