// hint: entry_of_zero
// or: missed_box
// Writes 0 for the entry of a box that is missed, and so takes boxes in which the ray begins for missed ones.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <functional>
#include <utility>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    const auto entry_or_zero = [&](int node) { return tree.entry(node).value_or(0); };
    std::optional<double> nearest;
    const std::function<void(int, double)> go_down = [&](int node, double entry) {
        if (nearest && *nearest < entry) return;
        if (const auto children = tree.children(node)) {
            std::pair near{entry_or_zero((*children)[0]), (*children)[0]};
            std::pair far{entry_or_zero((*children)[1]), (*children)[1]};
            if (far < near) std::swap(near, far);
            for (const auto& [at, child] : {near, far})
                if (at > 0) go_down(child, at);
        } else if (const auto t = tree.hit(node); t && (!nearest || *t < *nearest)) {
            nearest = t;
        }
    };
    if (const double entry = entry_or_zero(0); entry > 0) go_down(0, entry);
    return nearest;
}
