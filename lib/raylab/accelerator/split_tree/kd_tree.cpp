#include "raylab/accelerator/split_tree/kd_tree.h"

#include "raylab/accelerator/sorted_primitives.h"
#include "raylab/accelerator/split_tree/split_ray.h"
#include "raylab/geometry/bounds/ray_in_floats.h"

#include <array>
#include <limits>
#include <utility>

namespace raylab {

namespace {

// Numbers the parts by the first leaf that holds them, so that parts that are tested together lie together in memory;
// returns the order.
std::vector<std::uint32_t> renumber_by_leaf(SplitTree& tree, std::size_t count) {
    constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> order, number(count, unseen);
    for (std::uint32_t& part : tree.parts) {
        if (number[part] == unseen) {
            number[part] = static_cast<std::uint32_t>(order.size());
            order.push_back(part);
        }
        part = number[part];
    }
    return order;
}

constexpr auto unnoticed = [](std::uint32_t) {};

}  // namespace

KdTree::KdTree(const Scene& scene, const PlaneRule& rule) : KdTree(SortedPrimitives(scene), rule) {}

KdTree::KdTree(const SortedPrimitives& sorted, const PlaneRule& rule)
    : tree_(build_split_tree(sorted, rule)),
      bounded_(sorted.in_order(renumber_by_leaf(tree_, sorted.boxes.size()))),
      unbounded_(sorted.without_bounds()) {}

std::size_t KdTree::bytes() const {
    return tree_.nodes.capacity() * sizeof(SplitTree::Node) + tree_.parts.capacity() * sizeof(std::uint32_t) +
           bounded_.bytes() + unbounded_.bytes();
}

template <class AtNode, class AtLeaf>
void KdTree::visit(const Ray& ray, double end, Traversal& traversal, const AtNode& at_node,
                   const AtLeaf& at_leaf) const {
    if (tree_.nodes.empty()) return;
    ++traversal.box_tests;
    if (ray.range.min >= 0 && RayInFloats(ray, tree_.bounds).fit_floats())
        walk(SplitRay<float>(ray), end, traversal, at_node, at_leaf);
    else
        walk(SplitRay<double>(ray), end, traversal, at_node, at_leaf);
}

template <Real T, class AtNode, class AtLeaf>
void KdTree::walk(const SplitRay<T>& ray, double end, Traversal& traversal, const AtNode& at_node,
                  const AtLeaf& at_leaf) const {
    struct Later {
        std::uint32_t node;
        typename SplitRay<T>::Span span;
    };
    std::array<Later, SplitTree::max_depth> later;  // at most one half waits at each depth
    std::size_t waiting = 0;
    std::uint64_t steps = 0;
    Later at{0, ray.inside(tree_.bounds)};
    bool goes_on = !at.span.is_empty() && at.span.begin <= end;
    while (goes_on) {
        const SplitTree::Node& node = tree_.nodes[at.node];
        ++steps;
        at_node(at.node);
        if (!node.is_leaf()) {
            const auto crossing = ray.crossing(node.axis(), node.plane());
            const std::uint32_t nearer = ray.nearer_half(node.axis());
            at.node = node.below() + nearer;
            if (crossing.low > at.span.end) continue;  // written so that NaN does not leave a half out
            const std::uint32_t farther = node.above() - nearer;
            if (crossing.high < at.span.begin) {
                at.node = farther;
            } else {
                later[waiting++] = {farther, ray.beyond(crossing, at.span)};
                at.span = ray.before(crossing, at.span);
            }
            continue;
        }
        if (at_leaf(node, end)) break;
        do {
            goes_on = waiting > 0;
            if (goes_on) at = later[--waiting];
        } while (goes_on && !(at.span.begin <= end));
    }
    traversal.steps += steps;
}

template <class AtNode>
std::optional<Hit> KdTree::closest(const Ray& ray, Traversal& traversal, const AtNode& at_node) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < unbounded_.size(); ++i) unbounded_.test(i, ray, nearest, traversal);
    const TriangleQuickReject quick_reject = bounded_.quick_reject(ray);
    // A hit beyond the cell is kept: it is a hit, and any nearer one lies in the cells that are still visited.
    visit(ray, nearest.limit(), traversal, at_node, [&](const SplitTree::Node& leaf, double& end) {
        bounded_.test(tree_.in(leaf), ray, quick_reject, nearest, traversal);
        end = nearest.limit();
        return false;
    });
    return nearest.hit();
}

std::optional<Hit> KdTree::closest(const Ray& ray, Traversal& traversal) const {
    return closest(ray, traversal, unnoticed);
}

std::vector<Visit> KdTree::visits(const Ray& ray) const {
    const std::vector<Box> cells = this->cells();
    std::vector<Visit> visits;
    Traversal traversal;
    closest(ray, traversal, [&](std::uint32_t index) {
        const SplitTree::Node& node = tree_.nodes[index];
        const std::size_t tests = node.is_leaf() ? node.count() : 0;
        const auto kind = !node.is_leaf() ? Visit::Kind::inner : tests > 0 ? Visit::Kind::leaf : Visit::Kind::empty;
        visits.push_back({cells[index], kind, tests});
    });
    return visits;
}

bool KdTree::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return bounded_.hits(i, ray, traversal); })) return true;
    for (std::size_t i = 0; i < unbounded_.size(); ++i) {
        if (unbounded_.hits(i, ray, traversal)) return true;
    }
    bool hit = false;
    const TriangleQuickReject quick_reject = bounded_.quick_reject(ray);
    visit(ray, std::numeric_limits<double>::infinity(), traversal, unnoticed,
          [&](const SplitTree::Node& leaf, double&) {
              const auto blocker = bounded_.first_hit(tree_.in(leaf), ray, quick_reject, traversal);
              if (blocker) traversal.stopped_by(*blocker);
              hit = blocker.has_value();
              return hit;
          });
    return hit;
}

}  // namespace raylab
