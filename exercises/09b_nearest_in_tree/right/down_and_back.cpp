// Goes down through the nearer children, and back to the nearest that waits.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::vector<std::pair<double, int>> waiting;
    std::optional<double> nearest;
    auto at = tree.entry(0);
    int node = 0;
    while (at) {
        std::optional<double> next;
        int next_node = 0;
        if (const auto children = tree.children(node)) {
            for (const int child : *children) {
                const auto entry = tree.entry(child);
                if (entry && next) waiting.push_back(std::max(std::pair(*entry, child), std::pair(*next, next_node)));
                if (entry && (!next || *entry < *next)) {
                    next = entry;
                    next_node = child;
                }
            }
        } else if (const auto t = tree.hit(node)) {
            nearest = nearest ? std::min(*nearest, *t) : *t;
        }
        if (next && nearest && *next > *nearest) next.reset();
        while (!next && !waiting.empty()) {
            if (!nearest || waiting.back().first < *nearest) {
                next = waiting.back().first;
                next_node = waiting.back().second;
            }
            waiting.pop_back();
        }
        at = next;
        node = next_node;
    }
    return nearest;
}
