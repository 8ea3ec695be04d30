// hint: keep_the_nearer
// Of two hits it keeps the farther one.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> best;
    std::vector<std::pair<double, int>> waiting;
    if (const auto entry = tree.entry(0)) waiting.emplace_back(*entry, 0);
    while (!waiting.empty()) {
        const auto [entry, node] = waiting.back();
        waiting.pop_back();
        if (best && entry > *best) continue;
        const auto children = tree.children(node);
        if (!children) {
            const auto t = tree.hit(node);
            if (t && (!best || *t > *best)) best = t;
            continue;
        }
        const auto [one, other] = *children;
        const auto at_one = tree.entry(one), at_other = tree.entry(other);
        if (at_one && at_other && *at_one < *at_other) {
            waiting.emplace_back(*at_other, other);
            waiting.emplace_back(*at_one, one);
            continue;
        }
        if (at_one) waiting.emplace_back(*at_one, one);
        if (at_other) waiting.emplace_back(*at_other, other);
    }
    return best;
}
