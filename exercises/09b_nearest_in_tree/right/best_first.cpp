// The node that is entered first of all that wait: the first that is entered beyond the hit is the end.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <functional>
#include <queue>
#include <utility>
#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    using Waiting = std::pair<double, int>;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
    if (const auto at = tree.entry(0)) waiting.emplace(*at, 0);
    std::optional<double> nearest;
    while (!waiting.empty() && !(nearest && waiting.top().first >= *nearest)) {
        const int node = waiting.top().second;
        waiting.pop();
        if (const auto children = tree.children(node)) {
            for (const int child : *children)
                if (const auto at = tree.entry(child)) waiting.emplace(*at, child);
        } else if (const auto t = tree.hit(node); t && (!nearest || *t < *nearest)) {
            nearest = t;
        }
    }
    return nearest;
}
