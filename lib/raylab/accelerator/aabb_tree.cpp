#include "raylab/accelerator/aabb_tree.h"

#include "raylab/accelerator/ray_box.h"
#include "raylab/accelerator/sorted_primitives.h"

#include <array>
#include <utility>

namespace raylab {

AabbTree::AabbTree(const Scene& scene) : AabbTree(SortedPrimitives(scene)) {}

AabbTree::AabbTree(const SortedPrimitives& sorted) : AabbTree(sorted, build_box_tree(sorted.boxes)) {}

AabbTree::AabbTree(const SortedPrimitives& sorted, BoxTree tree)
    : nodes_(std::move(tree.nodes)), bounded_(sorted.in_order(std::move(tree.order))), unbounded_(sorted.without_bounds()) {}

std::size_t AabbTree::bytes() const {
    return nodes_.capacity() * sizeof(BoxTree::Node) + bounded_.bytes() + unbounded_.bytes();
}

template <class AtLeaf>
void AabbTree::visit(const BoxRay& ray, Traversal& traversal, const AtLeaf& at_leaf) const {
    struct Later {
        std::uint32_t first, count;
        double entry;
    };
    std::array<Later, BoxTree::max_depth> later;  // at most one sibling waits at each depth
    std::size_t waiting = 0;
    if (nodes_.empty()) return;

    Later next{0, 0, 0};
    while (true) {
        if (next.count > 0) {
            if (at_leaf(next.first, next.first + next.count)) return;
        } else {
            const BoxTree::Node& node = nodes_[next.first];
            ++traversal.steps;
            traversal.box_tests += 2;
            const auto [first, second] = ray.entries(node.planes);
            const std::size_t nearer = second < first ? 1 : 0, farther = 1 - nearer;
            const double entry = std::min(first, second), later_entry = std::max(first, second);
            if (ray.reaches(later_entry)) later[waiting++] = {node.first[farther], node.count[farther], later_entry};
            if (ray.reaches(entry)) {
                next = {node.first[nearer], node.count[nearer], entry};
                continue;
            }
        }
        do {
            if (waiting == 0) return;
            next = later[--waiting];
        } while (!ray.reaches(next.entry));
    }
}

std::optional<Hit> AabbTree::closest(const Ray& ray, Traversal& traversal) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < unbounded_.size(); ++i) unbounded_.test(i, ray, nearest, traversal);
    BoxRay box_ray(ray);
    box_ray.set_end(std::min<double>(ray.range.max, nearest.limit()));
    visit(box_ray, traversal, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) bounded_.test(i, ray, nearest, traversal);
        box_ray.set_end(std::min<double>(ray.range.max, nearest.limit()));
        return false;
    });
    return nearest.hit();
}

bool AabbTree::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return bounded_.hits(i, ray, traversal); })) return true;
    for (std::size_t i = 0; i < unbounded_.size(); ++i) {
        if (unbounded_.hits(i, ray, traversal)) return true;
    }
    bool hit = false;
    visit(BoxRay(ray), traversal, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end && !hit; ++i) {
            hit = bounded_.hits(i, ray, traversal);
            if (hit) traversal.stopped_by(i);
        }
        return hit;
    });
    return hit;
}

}  // namespace raylab
