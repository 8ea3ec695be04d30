#include "weak_tree.h"

#include "raylab/accelerator/sorted_primitives.h"
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::split {

namespace {

std::vector<std::uint32_t> in_scene_order(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
    return order;
}

float t_of(const Ray& ray, int axis, float plane) { return (plane - ray.origin[axis]) * (1 / ray.direction[axis]); }

}  // namespace

std::string words(Mistake mistake) {
    switch (mistake) {
        case Mistake::rounding:
            return "kd, rounded planes";
        case Mistake::in_doubles:
            return "kd, planes in doubles";
        case Mistake::only_inside:
            return "kd, hits only inside the cell";
        case Mistake::first_found:
            return "kd, first cell with a hit";
        default:
            return "kd, NaN to the far side";
    }
}

WeakTree::WeakTree(const Scene& scene, Mistake mistake) : WeakTree(SortedPrimitives(scene), mistake) {}

WeakTree::WeakTree(const SortedPrimitives& sorted, Mistake mistake)
    : mistake_(mistake),
      tree_(build_split_tree(sorted, surface_area_heuristic())),
      bounded_(sorted.in_order(in_scene_order(sorted.boxes.size()))),
      unbounded_(sorted.without_bounds()) {}

std::size_t WeakTree::bytes() const {
    return tree_.nodes.capacity() * sizeof(SplitTree::Node) + tree_.parts.capacity() * sizeof(std::uint32_t) +
           bounded_.bytes() + unbounded_.bytes();
}

// These mistakes are not about the root, so its box is enlarged.
WeakTree::Cell WeakTree::whole(const Ray& ray) const {
    Cell cell{0, {ray.range.min, std::min(ray.range.max, std::numeric_limits<float>::max())}};
    for (int axis = 0; axis < 3; ++axis) {
        const float a = t_of(ray, axis, tree_.bounds.min[axis]), b = t_of(ray, axis, tree_.bounds.max[axis]);
        if (std::isnan(a) || std::isnan(b)) continue;
        const float room = 1e-5f * std::max(std::abs(a), std::abs(b));
        cell.span.min = std::max<double>(cell.span.min, std::min(a, b) - room);
        cell.span.max = std::min<double>(cell.span.max, std::max(a, b) + room);
    }
    return cell;
}

std::vector<WeakTree::Cell> WeakTree::children(const Cell& cell, const Ray& ray) const {
    const SplitTree::Node& node = tree_.nodes[cell.node];
    const auto axis = static_cast<int>(node.axis());
    if (mistake_ == Mistake::in_doubles) {
        std::vector<Cell> visited;
        for (const auto& [half, span] : visited_halves(ray.origin[axis], ray.direction[axis], node.plane(), cell.span))
            visited.push_back({half == CellHalf::below ? node.below() : node.above(), span});
        std::ranges::reverse(visited);
        return visited;
    }
    const auto& [begin, end] = cell.span;
    const double t = t_of(ray, axis, node.plane());
    const bool backward = std::signbit(ray.direction[axis]);
    const std::uint32_t near = backward ? node.above() : node.below(), far = backward ? node.below() : node.above();
    const Cell all_near{near, cell.span}, all_far{far, cell.span};
    const std::vector<Cell> both{{far, {std::max(begin, t), end}}, {near, {begin, std::min(end, t)}}};
    if (mistake_ == Mistake::nan_goes_beyond) {
        if (t > begin && t < end) return both;
        return {t >= end ? all_near : all_far};
    }
    if (t > end) return {all_near};
    if (t < begin) return {all_far};
    return std::isnan(t) ? std::vector<Cell>{all_far, all_near} : both;
}

std::optional<Hit> WeakTree::closest(const Ray& ray, Traversal& traversal) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < unbounded_.size(); ++i) unbounded_.test(i, ray, nearest, traversal);
    std::vector<Cell> cells;
    if (!tree_.nodes.empty()) cells.push_back(whole(ray));
    while (!cells.empty()) {
        const Cell cell = cells.back();
        cells.pop_back();
        if (!(cell.span.min <= cell.span.max) || cell.span.min > nearest.limit()) continue;
        ++traversal.steps;
        const SplitTree::Node& node = tree_.nodes[cell.node];
        if (!node.is_leaf()) {
            for (const Cell& child : children(cell, ray)) cells.push_back(child);
            continue;
        }
        Ray inside = ray;
        if (mistake_ == Mistake::only_inside)
            inside.range = {std::max(ray.range.min, cast<float>(cell.span.min)),
                            std::min(ray.range.max, cast<float>(cell.span.max))};
        Nearest here(inside);
        const bool is_local = mistake_ == Mistake::only_inside || mistake_ == Mistake::first_found;
        Nearest& found = is_local ? here : nearest;
        for (std::uint32_t i = node.first(); i < node.first() + node.count(); ++i)
            bounded_.test(tree_.parts[i], inside, found, traversal);
        if (const auto hit = here.hit()) return nearest.hit() && nearest.hit()->t < hit->t ? nearest.hit() : hit;
    }
    return nearest.hit();
}

}  // namespace raylab::split
