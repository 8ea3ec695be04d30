// hint: far_away
// or: one_group
// A leaf without a hit gives a thousand, and a thousand at the end is taken for none.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    constexpr double nothing = 1e3;
    std::function<double(int, double, double)> nearer = [&](int node, double entry, double limit) {
        if (entry > limit) return limit;
        const auto children = tree.children(node);
        if (!children) return std::min(limit, tree.hit(node).value_or(nothing));
        const auto left = tree.entry((*children)[0]), right = tree.entry((*children)[1]);
        const auto go_left = [&] { return left ? nearer((*children)[0], *left, limit) : limit; };
        const auto go_right = [&] { return right ? nearer((*children)[1], *right, limit) : limit; };
        const bool right_first = left && right && *right < *left;
        limit = right_first ? go_right() : go_left();
        return right_first ? go_left() : go_right();
    };
    const auto at = tree.entry(0);
    const double t = at ? nearer(0, *at, nothing) : nothing;
    return t < nothing ? std::optional(t) : std::nullopt;
}
