// hint: keep_the_nearer
// The answer of the leaf asked last, even if it has none.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::vector<std::pair<double, int>> waiting;
    if (const auto at = tree.entry(0)) waiting.emplace_back(*at, 0);
    std::optional<double> hit;
    while (!waiting.empty()) {
        const auto [entry, node] = waiting.back();
        waiting.pop_back();
        if (hit && entry > *hit) continue;
        const auto children = tree.children(node);
        if (!children) {
            hit = tree.hit(node);
            continue;
        }
        const auto first = tree.entry((*children)[0]), second = tree.entry((*children)[1]);
        const bool is_first_nearer = first && (!second || *first <= *second);
        if (first && !is_first_nearer) waiting.emplace_back(*first, (*children)[0]);
        if (second) waiting.emplace_back(*second, (*children)[1]);
        if (is_first_nearer) waiting.emplace_back(*first, (*children)[0]);
    }
    return hit;
}
