// hint: first_is_not_nearest
// Goes into the second child only where the first one has no hit.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

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
        if (!at_first) return std::nullopt;
        if (const auto hit = search(first)) return hit;
        return at_second ? search(second) : std::nullopt;
    };
    return tree.entry(0) ? search(0) : std::nullopt;
}
