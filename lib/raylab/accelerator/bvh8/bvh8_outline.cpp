#include "raylab/accelerator/bvh8/bvh8.h"
#include "raylab/accelerator/bvh8/bvh8_leaves.h"
#include "raylab/accelerator/bvh8/bvh8_walk_in_doubles.h"

#include <bit>
#include <map>

namespace raylab {

namespace {

Box box_of(const Bvh8Node& node, std::size_t place) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = node.planes[static_cast<std::size_t>(axis)][place];
        box.max[axis] = node.planes[static_cast<std::size_t>(axis) + 3][place];
    }
    return box;
}

std::uint32_t name_of(Bvh8Child child) { return std::bit_cast<std::uint32_t>(child); }

// Records the nodes and leaves that the traversal visits.
class VisitLeaves final : public NearestLeaves {
public:
    VisitLeaves(const Bvh8Contents& contents, const Ray& ray, Traversal& traversal)
        : NearestLeaves(contents, ray, traversal) {
        Box all;
        for (const Bvh8Node& node : contents.tree().nodes)
            for (std::size_t place = 0; place < bvh8_width; ++place) {
                const Box box = box_of(node, place);
                if (box.is_empty()) continue;
                boxes_[name_of(node.children[place])] = box;
                all = unite(all, box);
            }
        boxes_[name_of(Bvh8Child::node(0))] = all;
    }

    void came_to(Bvh8Child child) override {
        const Visit::Kind kind = child.is_node() ? Visit::Kind::inner : Visit::Kind::leaf;
        visits_.push_back({boxes_.at(name_of(child)), kind, child.is_node() ? 0 : child.count()});
    }

    std::vector<Visit> visits() const { return visits_; }

private:
    std::map<std::uint32_t, Box> boxes_;
    std::vector<Visit> visits_;
};

}  // namespace

Outline Bvh8::outline() const {
    Outline outline;
    const auto& nodes = contents_.tree().nodes;
    if (nodes.empty()) return outline;
    Box all;
    for (std::size_t place = 0; place < bvh8_width; ++place) all = unite(all, box_of(nodes[0], place));
    outline.nodes.push_back({.bound = all});
    // standing_for[i] is the child that became node i of the outline.
    std::vector<Bvh8Child> standing_for{Bvh8Child::node(0)};
    for (std::size_t i = 0; i < standing_for.size(); ++i) {
        const Bvh8Child child = standing_for[i];
        if (!child.is_node()) {
            outline.nodes[i].primitives = contents_.places_in_scene(child);
            continue;
        }
        const Bvh8Node& node = nodes[child.first()];
        for (std::size_t place = 0; place < bvh8_width; ++place) {
            const Box box = box_of(node, place);
            if (box.is_empty()) continue;
            outline.nodes[i].children.push_back(static_cast<std::uint32_t>(outline.nodes.size()));
            outline.nodes.push_back({.bound = box});
            standing_for.push_back(node.children[place]);
        }
    }
    return outline;
}

std::vector<Visit> Bvh8::visits(const Ray& ray) const {
    Traversal traversal;
    VisitLeaves leaves(contents_, ray, traversal);
    walk(walks_.nearest_told, {ray, leaves.end(), contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.visits();
}

}  // namespace raylab
