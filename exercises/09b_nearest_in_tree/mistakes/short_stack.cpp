// hint: farther_forgotten
// Its stack has room for three nodes, and what does not fit is lost.
#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {
    using Waiting = std::pair<double, int>;
    std::array<Waiting, 3> stack{};
    std::size_t waiting = 0;
    const auto put = [&](const Waiting& node) {
        if (waiting < stack.size()) stack[waiting++] = node;
    };
    double nearest = std::numeric_limits<double>::infinity();
    if (const auto at = tree.entry(0)) put({*at, 0});
    while (waiting > 0) {
        const auto [entry, node] = stack[--waiting];
        if (entry > nearest) continue;
        const auto children = tree.children(node);
        if (!children) {
            if (const auto t = tree.hit(node)) nearest = std::min(nearest, *t);
            continue;
        }
        const auto one = tree.entry((*children)[0]), other = tree.entry((*children)[1]);
        Waiting near{one.value_or(-1), (*children)[0]}, far{other.value_or(-1), (*children)[1]};
        if (far.first < near.first) std::swap(near, far);
        if (far.first >= 0) put(far);
        if (near.first >= 0) put(near);
    }
    if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
    return nearest;
}
