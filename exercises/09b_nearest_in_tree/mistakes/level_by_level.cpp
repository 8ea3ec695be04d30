// hint: level_by_level
// All nodes of a level, sorted by their entries, and then those of the next.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::vector<std::pair<double, int>> level;
    if (const auto at = tree.entry(0)) level.emplace_back(*at, 0);
    while (!level.empty()) {
        std::sort(level.begin(), level.end());
        std::vector<std::pair<double, int>> next;
        for (const auto& [entry, node] : level) {
            if (nearest && entry > *nearest) break;
            if (const auto children = tree.children(node)) {
                for (const int child : *children)
                    if (const auto at = tree.entry(child)) next.emplace_back(*at, child);
            } else if (const auto t = tree.hit(node); t && (!nearest || *t < *nearest)) {
                nearest = t;
            }
        }
        level = next;
    }
    return nearest;
}
