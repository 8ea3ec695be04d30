// hint: every_leaf
// or: missed_box
// Recursion without a box.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <cmath>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::function<double(int)> search = [&](int node) {
        const auto children = tree.children(node);
        if (!children) return tree.hit(node).value_or(HUGE_VAL);
        const double right = search((*children)[1]);  // before the left one, whatever the compiler
        return std::min(search((*children)[0]), right);
    };
    const double t = search(0);
    return t < HUGE_VAL ? std::optional(t) : std::nullopt;
}
