// hint: none_is_no_number
// or: nothing_there, infinite
// Gives the infinity with which the search begins where nothing is hit.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <limits>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double nearest_below(const raylab::AskedTree& tree, int node, double entry, double nearest) {
    if (entry > nearest) return nearest;
    const auto children = tree.children(node);
    if (!children) return std::min(nearest, tree.hit(node).value_or(infinity));
    auto [one, other] = *children;
    double at_one = tree.entry(one).value_or(infinity), at_other = tree.entry(other).value_or(infinity);
    if (at_other < at_one) std::swap(one, other), std::swap(at_one, at_other);
    if (at_one < infinity) nearest = nearest_below(tree, one, at_one, nearest);
    if (at_other < infinity) nearest = nearest_below(tree, other, at_other, nearest);
    return nearest;
}

}  // namespace

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    const auto entry = tree.entry(0);
    if (!entry) return std::nullopt;
    return nearest_below(tree, 0, *entry, infinity);
}
