#include "raylab/accelerator/bvh8/bvh8_build.h"

#include "raylab/accelerator/bvh8/bvh8_leaf_writer.h"
#include "raylab/accelerator/bvh8/bvh8_split.h"
#include "raylab/base/error.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <vector>

namespace raylab {

namespace {

using namespace bvh8_parts;

std::vector<Reference> references(std::span<const Triangle> triangles, std::span<const Box> others) {
    const std::size_t count = triangles.size() + others.size();
    if (count > Bvh8Child::max_primitives)
        throw Error(fmt::format("expected at most 134 217 728 primitives, found {}", count));
    std::vector<Reference> found;
    found.reserve(count);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const FourFloats a = four(triangles[i].a), b = four(triangles[i].b), c = four(triangles[i].c);
        found.push_back({smaller(smaller(a, b), c), larger(larger(a, b), c), i, Kind::triangle});
    }
    for (std::size_t i = 0; i < others.size(); ++i)
        found.push_back({four(others[i].min), four(others[i].max), i, Kind::other});
    return found;
}

class Builder {
public:
    Builder(std::span<const Triangle> triangles, std::span<const Box> others)
        : triangles_(triangles), references_(references(triangles, others)) {
        Extent all;
        for (const Triangle& triangle : triangles) {
            all.add(four(triangle.a));
            all.add(four(triangle.b));
            all.add(four(triangle.c));
        }
        for (int axis = 0; axis < 3; ++axis)
            if (all.min[axis] < -Bvh8Nodes::farthest || all.max[axis] > Bvh8Nodes::farthest) tree_.is_far = true;
        tree_.min_corner = std::bit_cast<std::array<float, 4>>(all.min);
        tree_.largest_corner = std::bit_cast<std::array<float, 4>>(all.max);
        tree_.others.reserve(others.size());
    }

    Bvh8Nodes build() {
        const ReferenceRange all = references_.all();
        if (all.size() == 0) return {};
        // Bytes for each triangle: those of meshes need 27 to 29.
        tree_.leaves.reserve(triangles_.size() * 30 / sizeof(Bvh8Line));
        tree_.nodes.reserve(all.size() / 12 + 1);
        grow(all, 1);
        give_back_rest(tree_.nodes);
        give_back_rest(tree_.leaves);
        if (tree_.leaves.size() > Bvh8Child::max_lines)
            throw Error(fmt::format("expected leaves of at most 8 GiB, found {} bytes",
                                    sizeof(Bvh8Line) * tree_.leaves.size()));
        return std::move(tree_);
    }

private:
    // Frees unused memory where it is enough to be worth copying the rest.
    template <class T>
    static void give_back_rest(LargeVector<T>& some) {
        if (some.size() < some.capacity() / 8 * 7) some.shrink_to_fit();
    }

    std::size_t grow(const ReferenceRange& part, int depth) {
        std::array<ReferenceRange, bvh8_width> parts{part};
        const std::size_t count = divide(parts, depth);
        const std::size_t index = tree_.nodes.size();
        for (std::size_t i = 0; i < count; ++i)
            if (parts[i].size() <= bvh8_width) prefetch(parts[i]);
        tree_.nodes.emplace_back();
        for (std::size_t i = 0; i < count; ++i) set_box(tree_.nodes[index], i, parts[i].box);
        for (std::size_t i = 0; i < count; ++i) {
            const Bvh8Child child =
                references_.fit_in_leaf(parts[i]) ? leaf(parts[i]) : Bvh8Child::node(grow(parts[i], depth + 1));
            tree_.nodes[index].children[i] = child;
        }
        return index;
    }

    // Prefetches the triangles of a node all at once, because they are scattered in memory.
    void prefetch(const ReferenceRange& part) const {
        for (const Reference& one : references_.of(part))
            if (one.is_triangle()) __builtin_prefetch(&triangles_[one.number()]);
    }

    static void set_box(Bvh8Node& node, std::size_t place, const Extent& box) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<std::size_t>(axis);
            node.planes[row][place] = box.min[axis] < -Bvh8Nodes::largest ? -infinity : box.min[axis];
            node.planes[row + 3][place] = box.max[axis] > Bvh8Nodes::largest ? infinity : box.max[axis];
        }
    }

    // Splits the largest part that is not a leaf until there are eight parts, or only leaves. Returns the number of
    // parts.
    std::size_t divide(std::array<ReferenceRange, bvh8_width>& parts, int depth) {
        std::size_t count = 1;
        while (count < bvh8_width) {
            ReferenceRange* largest = nullptr;
            for (std::size_t i = 0; i < count; ++i)
                if (!references_.fit_in_leaf(parts[i]) &&
                    (!largest || parts[i].box.half_area() > largest->box.half_area()))
                    largest = &parts[i];
            if (!largest) break;
            const auto [left, right] = references_.split(*largest, depth);
            *largest = left;
            parts[count++] = right;
        }
        return count;
    }

    Bvh8Child leaf(const ReferenceRange& part) {
        const std::span<const Reference> found = references_.of(part);
        if (!found[0].is_triangle()) {
            tree_.others.push_back(found[0].number());
            return Bvh8Child::leaf(Bvh8Child::Kind::others, tree_.others.size() - 1, 1);
        }
        Bvh8LeafWriter writer;
        for (const Reference& one : found) writer.add(triangles_[one.number()], one.number());
        tree_.triangle_count += found.size();
        return Bvh8Child::leaf(Bvh8Child::Kind::triangles, writer.append_to(tree_.leaves), found.size());
    }

    std::span<const Triangle> triangles_;
    References references_;
    Bvh8Nodes tree_;
};

}  // namespace

Bvh8Nodes build_bvh8_nodes(std::span<const Triangle> triangles, std::span<const Box> others) {
    return Builder(triangles, others).build();
}

}  // namespace raylab
