// hint: every_leaf
// or: missed_box
// All leaves, one after the other.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <vector>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::vector<int> nodes{0};
    while (!nodes.empty()) {
        const int node = nodes.back();
        nodes.pop_back();
        if (const auto children = tree.children(node)) {
            nodes.insert(nodes.end(), children->begin(), children->end());
        } else if (const auto t = tree.hit(node); t && (!nearest || *t < *nearest)) {
            nearest = t;
        }
    }
    return nearest;
}
