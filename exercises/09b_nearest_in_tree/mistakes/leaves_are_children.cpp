// hint: root
// Looks for leaves among the children of a node alone, so that a root which is a leaf is never asked.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <utility>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::function<void(const std::array<int, 2>&)> search = [&](const std::array<int, 2>& nodes) {
        std::array<std::pair<std::optional<double>, int>, 2> pair{
            {{tree.entry(nodes[0]), nodes[0]}, {tree.entry(nodes[1]), nodes[1]}}};
        std::sort(pair.begin(), pair.end());
        for (const auto& [entry, node] : pair) {
            if (!entry || (nearest && *entry > *nearest)) continue;
            if (const auto below = tree.children(node))
                search(*below);
            else if (const auto t = tree.hit(node))
                nearest = std::min(*t, nearest.value_or(*t));
        }
    };
    if (const auto top = tree.children(0); top && tree.entry(0)) search(*top);
    return nearest;
}
