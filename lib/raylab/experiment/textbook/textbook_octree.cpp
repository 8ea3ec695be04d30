#include "raylab/experiment/textbook/textbook_octree.h"

#include "raylab/geometry/intersect/nearest.h"

#include <algorithm>
#include <limits>

namespace raylab {

double exit_of(const OctreeCube& cube, const Vec3d& origin, const Vec3d& direction) {
    double exit = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double plane = direction[axis] > 0 ? cube.low[axis] + cube.side : cube.low[axis];
        exit = std::min(exit, (plane - origin[axis]) / direction[axis]);
    }
    return exit;
}

namespace {

Box box_about(const Primitives& primitives) {
    Box all;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (const auto box = primitives.bounds(i)) all = unite(all, *box);
    return all;
}

OctreeCells build(const Primitives& primitives, const Lattice& lattice, int depth) {
    std::vector<LatticeShape> shapes;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        shapes.push_back({lattice.touched(*primitives.bounds(i))});
        if (const auto triangle = primitives.triangle(i)) shapes.back().triangle.emplace(lattice, *triangle);
    }
    return build_octree(shapes, {.few = 1, .depth = depth});
}

}  // namespace

TextbookOctree::TextbookOctree(const Scene& scene, const NextPoint& next_point, End end)
    : primitives_(scene),
      lattice_(box_about(primitives_)),
      tree_(build(primitives_, lattice_, depth_)),
      next_point_(next_point),
      end_(end) {}

std::size_t TextbookOctree::bytes() const {
    return primitives_.bytes() + tree_.cells.capacity() * sizeof(OctreeCell) +
           tree_.references.capacity() * sizeof(std::uint32_t);
}

std::optional<TextbookOctree::Leaf> TextbookOctree::leaf_at(const Vec3d& point, Traversal& traversal) const {
    for (int axis = 0; axis < 3; ++axis)
        if (!(point[axis] >= 0 && point[axis] < Lattice::side)) return std::nullopt;
    const LatticeCell at{static_cast<std::int32_t>(point.x), static_cast<std::int32_t>(point.y),
                         static_cast<std::int32_t>(point.z)};
    std::uint32_t block = 0;
    for (int size = Lattice::bits;; --size) {
        ++traversal.steps;
        const OctreeCell cell = tree_.cells[block + place_in_block(at, size, 1)];
        block = cell.first;
        const auto low = [&](std::size_t axis) { return static_cast<double>(at[axis] & -(1 << size)); };
        if (!cell.is_divided()) return Leaf{cell, {{low(0), low(1), low(2)}, static_cast<double>(1 << size)}};
    }
}

std::optional<Hit> TextbookOctree::closest(const Ray& ray, Traversal& traversal) const {
    Nearest nearest(ray);
    Vec3d origin, direction;
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = lattice_.place(static_cast<std::size_t>(axis), ray.origin[axis]);
        direction[axis] = ray.direction[axis] / lattice_.width();
    }
    const LatticeRay entering(lattice_, ray);
    if (!(entering.start() <= entering.end())) return std::nullopt;
    Vec3d point = origin + entering.start() * direction;
    constexpr int enough = 4 << depth_;  // a traversal that no longer advances has to be stopped
    for (int steps = 0; steps < enough; ++steps) {
        const auto leaf = leaf_at(point, traversal);
        if (!leaf) break;
        for (const std::uint32_t i : tree_.in(leaf->cell)) primitives_.test(i, ray, nearest, traversal);
        const double enough_t =
            end_ == End::at_first_hit ? std::numeric_limits<double>::max() : exit_of(leaf->cube, origin, direction);
        if (nearest.limit() <= enough_t) break;
        point = next_point_(leaf->cube, smallest_, origin, direction);
    }
    return nearest.hit();
}

}  // namespace raylab
