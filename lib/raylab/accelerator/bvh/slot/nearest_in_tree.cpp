#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    struct Entered {
        int node;
        double entry;
    };
    std::vector<Entered> waiting;  // the nearer ones last
    if (const auto entry = tree.entry(0)) waiting.push_back({0, *entry});
    std::optional<double> nearest;
    while (!waiting.empty()) {
        const auto [node, entry] = waiting.back();
        waiting.pop_back();
        if (nearest && entry > *nearest) continue;  // it was put there before this hit was known
        const auto children = tree.children(node);
        if (!children) {
            if (const auto hit = tree.hit(node); hit && (!nearest || *hit < *nearest)) nearest = hit;
            continue;
        }
        const std::size_t before = waiting.size();
        for (const int child : *children)
            if (const auto at = tree.entry(child)) waiting.push_back({child, *at});
        if (waiting.size() == before + 2 && waiting[before].entry < waiting[before + 1].entry)
            std::swap(waiting[before], waiting[before + 1]);
    }
    return nearest;
}
