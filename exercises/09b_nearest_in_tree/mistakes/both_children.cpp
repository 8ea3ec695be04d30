// hint: early_end
// Searches both children and takes the smaller result.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <utility>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::function<std::optional<double>(int)> search = [&](int node) -> std::optional<double> {
        const auto children = tree.children(node);
        if (!children) return tree.hit(node);
        auto [first, second] = *children;
        auto at_first = tree.entry(first), at_second = tree.entry(second);
        if (at_second && (!at_first || *at_second < *at_first)) {
            std::swap(first, second);
            std::swap(at_first, at_second);
        }
        const auto one = at_first ? search(first) : std::nullopt;
        const auto other = at_second ? search(second) : std::nullopt;
        if (one && other) return std::min(*one, *other);
        return one ? one : other;
    };
    return tree.entry(0) ? search(0) : std::nullopt;
}
