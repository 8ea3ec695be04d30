#include "plane_tree.h"

#include <cmath>

namespace raylab::split {

namespace {

// Positive before the wall's line, negative behind it.
double side_of(const Wall& wall, PlanePoint point) {
    const double along_x = wall.to.x - wall.from.x, along_y = wall.to.y - wall.from.y;
    return along_x * (point.y - wall.from.y) - along_y * (point.x - wall.from.x);
}

PlanePoint crossing(const Wall& line, PlanePoint a, PlanePoint b) {
    const double at_a = side_of(line, a), at_b = side_of(line, b), share = at_a / (at_a - at_b);
    return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

// The part of a convex region where sign * side_of() >= 0.
std::vector<PlanePoint> part(const std::vector<PlanePoint>& region, const Wall& line, double sign) {
    std::vector<PlanePoint> kept;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const PlanePoint here = region[i], next = region[(i + 1) % region.size()];
        const double a = sign * side_of(line, here), b = sign * side_of(line, next);
        if (a >= 0) kept.push_back(here);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push_back(crossing(line, here, next));
    }
    return kept;
}

}  // namespace

PlaneTree plane_tree(const std::vector<PlanePoint>& region, const std::vector<Wall>& walls) {
    PlaneTree tree{region};
    if (walls.empty()) return tree;
    const Wall line = walls.front();
    std::vector<Wall> behind, before;
    constexpr double in_line = 1e-9;
    for (const Wall& wall : walls) {
        const double a = side_of(line, wall.from), b = side_of(line, wall.to);
        if (std::abs(a) < in_line && std::abs(b) < in_line) {
            tree.walls.push_back(wall);
        } else if (a <= in_line && b <= in_line) {
            behind.push_back(wall);
        } else if (a >= -in_line && b >= -in_line) {
            before.push_back(wall);
        } else {
            const PlanePoint cut = crossing(line, wall.from, wall.to);
            (a < 0 ? behind : before).push_back({wall.name + "'", wall.from, cut});
            (a < 0 ? before : behind).push_back({wall.name + "\"", cut, wall.to});
        }
    }
    tree.behind = std::make_unique<PlaneTree>(plane_tree(part(region, line, -1), behind));
    tree.before = std::make_unique<PlaneTree>(plane_tree(part(region, line, 1), before));
    return tree;
}

std::vector<const PlaneTree*> front_to_back(const PlaneTree& tree, PlanePoint eye) {
    if (tree.walls.empty()) return {&tree};
    const bool is_before = side_of(tree.walls.front(), eye) > 0;
    auto leaves = front_to_back(is_before ? *tree.before : *tree.behind, eye);
    const auto far = front_to_back(is_before ? *tree.behind : *tree.before, eye);
    leaves.insert(leaves.end(), far.begin(), far.end());
    return leaves;
}

}  // namespace raylab::split
