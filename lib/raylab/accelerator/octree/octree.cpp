#include "raylab/accelerator/octree/octree.h"

#include "raylab/accelerator/list.h"
#include "raylab/accelerator/octree/octree_outline.h"
#include "raylab/accelerator/sorted_primitives.h"

#include <cmath>
#include <utility>

namespace raylab {

namespace {

bool is_finite(const Box& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(box.min[axis]) || !std::isfinite(box.max[axis])) return false;
    return true;
}

Box box_about(std::span<const Box> boxes) {
    Box all;
    for (const Box& box : boxes) all = unite(all, box);
    return all;
}

// Boxes that a lattice cannot hold are treated as unbounded.
SortedPrimitives with_finite_boxes(SortedPrimitives sorted) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sorted.boxes.size(); ++i) {
        if (is_finite(sorted.boxes[i])) {
            sorted.boxes[kept] = sorted.boxes[i];
            sorted.bounded[kept++] = sorted.bounded[i];
        } else {
            sorted.unbounded.push_back(sorted.bounded[i]);
        }
    }
    sorted.boxes.resize(kept);
    sorted.bounded.resize(kept);
    return sorted;
}

OctreeCells build(const SortedPrimitives& sorted, const Lattice& lattice, const OctreeLimits& limits) {
    std::vector<LatticeShape> shapes;
    shapes.reserve(sorted.boxes.size());
    for (std::size_t i = 0; i < sorted.boxes.size(); ++i) {
        shapes.push_back({lattice.touched(sorted.boxes[i])});
        if (limits.assign == OctreeLimits::Assign::by_box) continue;
        if (const auto triangle = sorted.all.triangle(sorted.bounded[i]))
            shapes.back().triangle.emplace(lattice, *triangle);
    }
    return build_octree(shapes, limits);
}

// The boxes in the order in which the leaves first name them; the references are renumbered by that order. So the
// primitives of a leaf lie next to each other in memory.
std::vector<std::uint32_t> renumber(std::vector<std::uint32_t>& references, std::size_t count) {
    constexpr std::uint32_t unnamed = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> order, number(count, unnamed);
    order.reserve(count);
    for (std::uint32_t& reference : references) {
        if (number[reference] == unnamed) {
            number[reference] = static_cast<std::uint32_t>(order.size());
            order.push_back(reference);
        }
        reference = number[reference];
    }
    return order;
}

}  // namespace

template <class Way>
struct OctreeBy<Way>::Parts {
    SortedPrimitives sorted;
    Lattice lattice;
    OctreeCells tree;
    std::vector<std::uint32_t> order;

    Parts(const Scene& scene, const OctreeLimits& limits)
        : sorted(with_finite_boxes(SortedPrimitives(scene))),
          lattice(box_about(sorted.boxes)),
          tree(build(sorted, lattice, limits)),
          order(renumber(tree.references, sorted.boxes.size())) {}
};

template <class Way>
OctreeBy<Way>::OctreeBy(const Scene& scene) : OctreeBy(scene, Way::limits()) {}

template <class Way>
OctreeBy<Way>::OctreeBy(const Scene& scene, const OctreeLimits& limits) : OctreeBy(Parts(scene, limits)) {}

template <class Way>
OctreeBy<Way>::OctreeBy(Parts parts)
    : lattice_(parts.lattice),
      tree_(std::move(parts.tree)),
      way_(tree_),
      bounded_(parts.sorted.in_order(parts.order)),
      unbounded_(parts.sorted.without_bounds()) {}

template <class Way>
std::size_t OctreeBy<Way>::bytes() const {
    return tree_.cells.capacity() * sizeof(OctreeCell) + tree_.references.capacity() * sizeof(std::uint32_t) +
           way_.bytes() + bounded_.bytes() + unbounded_.bytes();
}

template <class Way>
template <class Record>
std::optional<Hit> OctreeBy<Way>::trace(const Ray& ray, Traversal& traversal, const Record& record) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < unbounded_.size(); ++i) unbounded_.test(i, ray, nearest, traversal);
    const LatticeRay lattice_ray(lattice_, ray);
    if (!lattice_ray.fits_lattice()) {
        for (std::size_t i = 0; i < bounded_.size(); ++i) bounded_.test(i, ray, nearest, traversal);
        return nearest.hit();
    }
    const TriangleQuickReject quick_reject = bounded_.quick_reject(ray);
    // A hit outside the leaf counts, too: the traversal ends at the first cell that begins beyond it.
    way_.walk(tree_, lattice_ray, traversal.steps, [&](const FoundLeaf& leaf) {
        bounded_.test(tree_.in(leaf.cell), ray, quick_reject, nearest, traversal);
        record(leaf);
        return nearest.limit();
    });
    return nearest.hit();
}

template <class Way>
std::optional<Hit> OctreeBy<Way>::closest(const Ray& ray, Traversal& traversal) const {
    return trace(ray, traversal, [](const FoundLeaf&) {});
}

template <class Way>
std::vector<Visit> OctreeBy<Way>::visits(const Ray& ray) const {
    std::vector<Visit> visits;
    const LatticeRay lattice_ray(lattice_, ray);
    Traversal traversal;
    trace(ray, traversal, [&](const FoundLeaf& leaf) {
        const std::size_t tests = leaf.cell.rest;
        const Box box = lattice_.box(lattice_ray.as_lattice_counts(leaf.in, leaf.size), leaf.size);
        visits.push_back({box, tests > 0 ? Visit::Kind::leaf : Visit::Kind::empty, tests});
    });
    return visits;
}

template <class Way>
bool OctreeBy<Way>::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return bounded_.hits(i, ray, traversal); })) return true;
    for (std::size_t i = 0; i < unbounded_.size(); ++i) {
        if (unbounded_.hits(i, ray, traversal)) return true;
    }
    const LatticeRay lattice_ray(lattice_, ray);
    if (!lattice_ray.fits_lattice()) return occluded_by_any(bounded_, ray, traversal);
    const TriangleQuickReject quick_reject = bounded_.quick_reject(ray);
    bool hit = false;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    way_.walk(tree_, lattice_ray, traversal.steps, [&](const FoundLeaf& leaf) {
        const auto blocker = bounded_.first_hit(tree_.in(leaf.cell), ray, quick_reject, traversal);
        if (blocker) traversal.stopped_by(*blocker);
        hit = blocker.has_value();
        return hit ? -infinity : infinity;
    });
    return hit;
}

template <class Way>
Outline OctreeBy<Way>::outline() const {
    return outline_of(lattice_, tree_, bounded_.places());
}

template class OctreeBy<Parametric>;
template class OctreeBy<PointSearch>;
template class OctreeBy<HashTable>;
template class OctreeBy<Seads>;

}  // namespace raylab
