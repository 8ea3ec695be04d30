#include "raylab/accelerator/bvh8/bvh8.h"
#include "raylab/accelerator/bvh8/bvh8_visits.h"
#include "raylab/accelerator/bvh8/bvh8_walk_in_doubles.h"

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

Bvh8Boxes boxes_of(const Bvh8Nodes& tree) {
    Bvh8Boxes boxes;
    Box all;
    for (const Bvh8Node& node : tree.nodes)
        for (std::size_t place = 0; place < bvh8_width; ++place) {
            const Box box = box_of(node, place);
            if (box.is_empty()) continue;
            boxes[node.children[place]] = box;
            all = unite(all, box);
        }
    boxes[Bvh8Child::node(0)] = all;
    return boxes;
}

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
    Bvh8Visits leaves(contents_, boxes_of(contents_.tree()), ray, traversal);
    const Bvh8Query query{ray, leaves.end(), contents_.number_left_by(ray)};
    if (!walks_.nearest_told(contents_.tree(), query, leaves, traversal))
        walk_in_doubles(contents_.tree(), query, leaves, traversal);
    return leaves.visits();
}

}  // namespace raylab
