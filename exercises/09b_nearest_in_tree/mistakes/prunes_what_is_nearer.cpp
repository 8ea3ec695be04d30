// hint: pruned_the_wrong_way
// > and < have changed places.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    std::optional<double> nearest;
    std::function<void(int, double)> visit = [&](int node, double entry) {
        if (nearest && entry < *nearest) return;
        const auto children = tree.children(node);
        if (!children) {
            const auto t = tree.hit(node);
            if (t && (!nearest || *t < *nearest)) nearest = t;
            return;
        }
        auto [near, far] = *children;
        auto at_near = tree.entry(near), at_far = tree.entry(far);
        if (at_far && (!at_near || *at_far < *at_near)) {
            std::swap(near, far);
            std::swap(at_near, at_far);
        }
        if (at_near) visit(near, *at_near);
        if (at_far) visit(far, *at_far);
    };
    if (const auto at = tree.entry(0)) visit(0, *at);
    return nearest;
}
