#include "raylab/accelerator/ray_space/ray_space.h"

#include "raylab/accelerator/sorted_primitives.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace raylab {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr RayCell nothing{
    0, {infinity, infinity, infinity, infinity, infinity}, {-infinity, -infinity, -infinity, -infinity, -infinity}};

std::vector<std::uint32_t> all_of(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    return order;
}

// The smallest cell that holds all points of a face.
RayCell cell_about(const std::vector<RayPoint>& points, int face) {
    RayCell cell = nothing;
    cell.face = face;
    for (const RayPoint& point : points)
        for (std::size_t i = 0; i < 5; ++i) {
            cell.low[i] = std::min(cell.low[i], point.at[i]);
            cell.high[i] = std::max(cell.high[i], point.at[i]);
        }
    return cell;
}

// x rounded down to a float, at most the largest one.
float float_below(double x) {
    const double largest = std::numeric_limits<float>::max();
    return cast<float>(std::min(x * (1 - 0x1p-22), largest));
}

}  // namespace

RaySpace::RaySpace(const Scene& scene, std::span<const Ray> expected, const Accelerator& others,
                   const RaySpaceOptions& options)
    : RaySpace(SortedPrimitives(scene), expected, others, options) {}

RaySpace::RaySpace(const SortedPrimitives& sorted, std::span<const Ray> expected, const Accelerator& others,
                   const RaySpaceOptions& options)
    : others_(others),
      options_(options),
      bounded_(sorted.in_order(all_of(sorted.boxes.size()))),
      unbounded_(sorted.without_bounds()),
      boxes_(sorted.boxes) {
    std::array<Points, 6> points;
    for (const Ray& ray : expected)
        if (const auto point = ray_point(ray)) points[static_cast<std::size_t>(point->face)].push_back(*point);
    Box scene;
    for (const Box& box : boxes_) scene = unite(scene, box);
    across_ = scene.is_empty() ? 0 : glm::length(convert<double>(scene.max) - convert<double>(scene.min));
    Items all;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) all.push_back({i, 0});
    nodes_.resize(6);
    for (std::size_t face = 0; face < 6; ++face) {
        roots_[face] = cell_about(points[face], static_cast<int>(face));
        if (!points[face].empty()) subdivide(face, roots_[face], within(roots_[face], all), points[face], 0);
    }
    boxes_ = {};
}

RaySpace::Items RaySpace::within(const RayCell& cell, const Items& items) const {
    Items hit_found;
    for (const Item& item : items)
        if (const auto depth = cell.depth_of(boxes_[item.primitive]))
            hit_found.push_back({item.primitive, float_below(*depth)});
    return hit_found;
}

// The axis along which the cell's rays spread most. A spread of directions counts by where it leads after half the
// scene's width.
std::size_t RaySpace::widest(const RayCell& cell) const {
    std::size_t widest = 0;
    double largest = -1;
    for (std::size_t i = 0; i < 5; ++i) {
        const double width = (cell.high[i] - cell.low[i]) * (i < 3 ? 1 : across_ / 2);
        if (width > largest) {
            largest = width;
            widest = i;
        }
    }
    return widest;
}

void RaySpace::subdivide(std::size_t node, const RayCell& cell, const Items& items, const Points& points, int depth) {
    const std::size_t axis = widest(cell);
    const double cut = cell.low[axis] / 2 + cell.high[axis] / 2;
    const bool cuts = cut > cell.low[axis] && cut < cell.high[axis];
    if (!cuts || items.size() <= options_.few_items || points.size() <= options_.few_rays || depth == options_.depth)
        return make_leaf(node, items);
    Points below, above;
    for (const RayPoint& point : points) (point.at[axis] <= cut ? below : above).push_back(point);
    const std::size_t first = nodes_.size();
    nodes_[node] = {static_cast<std::uint32_t>(axis), static_cast<std::uint32_t>(first), cut};
    nodes_.resize(first + 2);
    const RayCell low = cell.below(axis, cut), high = cell.above(axis, cut);
    subdivide(first, low, within(low, items), below, depth + 1);
    subdivide(first + 1, high, within(high, items), above, depth + 1);
}

void RaySpace::make_leaf(std::size_t node, Items items) {
    std::ranges::stable_sort(items, {}, &Item::depth);
    nodes_[node] = {is_leaf, static_cast<std::uint32_t>(leaves_.size()), 0};
    const auto first = static_cast<std::uint32_t>(items_.size());
    items_.insert(items_.end(), items.begin(), items.end());
    leaves_.push_back({first, static_cast<std::uint32_t>(items_.size())});
}

std::optional<std::span<const RaySpace::Item>> RaySpace::items_of(const RayPoint& point, Traversal& traversal) const {
    const auto face = static_cast<std::size_t>(point.face);
    if (!roots_[face].contains(point)) return std::nullopt;
    const Node* node = &nodes_[face];
    for (++traversal.steps; node->axis != is_leaf; ++traversal.steps)
        node = &nodes_[node->first + (point.at[node->axis] <= node->cut ? 0 : 1)];
    const auto [first, end] = leaves_[node->first];
    return std::span(items_).subspan(first, end - first);
}

std::optional<Hit> RaySpace::closest(const Ray& ray, Traversal& traversal) const {
    const auto point = ray_point(ray);
    const auto items = point ? items_of(*point, traversal) : std::nullopt;
    if (!items) return others_.closest(ray, traversal);
    Nearest nearest(ray);
    for (std::size_t i = 0; i < unbounded_.size(); ++i) unbounded_.test(i, ray, nearest, traversal);
    for (const Item& item : *items) {
        if (item.depth > nearest.limit() * point->along * (1 + 0x1p-40)) break;  // and so do all items that follow
        bounded_.test(item.primitive, ray, nearest, traversal);
    }
    return nearest.hit();
}

bool RaySpace::occluded(const Ray& ray, Traversal& traversal) const {
    const auto point = ray_point(ray);
    const auto items = point ? items_of(*point, traversal) : std::nullopt;
    if (!items) return others_.occluded(ray, traversal);
    for (std::size_t i = 0; i < unbounded_.size(); ++i)
        if (unbounded_.hits(i, ray, traversal)) return true;
    for (const Item& item : *items) {
        if (item.depth > ray.range.max * point->along * (1 + 0x1p-40)) return false;
        if (bounded_.hits(item.primitive, ray, traversal)) return true;
    }
    return false;
}

std::size_t RaySpace::bytes() const {
    return bounded_.bytes() + unbounded_.bytes() + nodes_.capacity() * sizeof(Node) +
           leaves_.capacity() * sizeof(Leaf) + items_.capacity() * sizeof(Item);
}

}  // namespace raylab
