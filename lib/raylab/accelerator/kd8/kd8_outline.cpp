#include "raylab/accelerator/bvh8/bvh8_visits.h"
#include "raylab/accelerator/kd8/kd8.h"

#include <span>
#include <utility>
#include <vector>

namespace raylab {

namespace {

Box cell_of(const Kd8Node& node, std::size_t cell, const Box& whole) {
    Box box = whole;
    for (int level = 0; level < 3; ++level) {
        const std::size_t place = Kd8Node::plane_between(cell, level);
        const auto axis = static_cast<int>(node.children[place].axis());
        (Kd8Node::is_above(cell, level) ? box.min : box.max)[axis] = node.planes[place];
    }
    return box;
}

// The leaves of triangles and of others in a cell.
std::vector<Bvh8Child> leaves_of(const Kd8Cells& cells, Kd8Child cell) {
    if (cell.is_none() || cell.is_node()) return {};
    if (!cell.is_list()) return {cell.leaf()};
    const std::span<const Bvh8Child> leaves = cells.leaves_of(cell);
    return {leaves.begin(), leaves.end()};
}

// A cell that holds something, and how large it is.
struct Cell {
    Kd8Child content;
    Box box;
};

// All of them, parents before their children, whose places are told.
struct AllCells {
    std::vector<Cell> cells;
    std::vector<std::vector<std::uint32_t>> children;

    explicit AllCells(const Kd8Cells& of) {
        if (of.root.is_none()) return;
        cells.push_back({of.root, of.bounds});
        for (std::size_t i = 0; i < cells.size(); ++i) {
            children.emplace_back();
            const auto [content, box] = cells[i];
            if (!content.is_node()) continue;
            const Kd8Node& node = of.nodes[content.first()];
            for (std::size_t cell = 0; cell < bvh8_width; ++cell) {
                if (node.children[cell].is_none()) continue;
                children.back().push_back(static_cast<std::uint32_t>(cells.size()));
                cells.push_back({node.children[cell], cell_of(node, cell, box)});
            }
        }
    }
};

Bvh8Boxes boxes_of(const Kd8Cells& cells) {
    Bvh8Boxes boxes;
    for (const auto& [content, box] : AllCells(cells).cells) {
        if (content.is_node()) boxes[Bvh8Child::node(content.first())] = box;
        for (const Bvh8Child leaf : leaves_of(cells, content)) boxes[leaf] = box;
    }
    return boxes;
}

}  // namespace

Outline Kd8::outline() const {
    const AllCells all(cells_);
    Outline outline;
    for (std::size_t i = 0; i < all.cells.size(); ++i) {
        Outline::Node node{.bound = all.cells[i].box, .children = all.children[i]};
        for (const Bvh8Child leaf : leaves_of(cells_, all.cells[i].content)) {
            const std::vector<std::uint32_t> places = contents_.places_in_scene(leaf);
            node.primitives.insert(node.primitives.end(), places.begin(), places.end());
        }
        outline.nodes.push_back(std::move(node));
    }
    return outline;
}

std::vector<Visit> Kd8::visits(const Ray& ray) const {
    Traversal traversal;
    Bvh8Visits leaves(contents_, boxes_of(cells_), ray, traversal);
    walk(walks_.nearest_told, {ray, leaves.end(), contents_.number_left_by(ray)}, leaves, traversal);
    return leaves.visits();
}

}  // namespace raylab
