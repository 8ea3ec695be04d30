#pragma once

#include "raylab/accelerator/primitives.h"
#include "raylab/accelerator/wide/wide_node.h"

#include <cstdint>
#include <vector>

namespace raylab {

/// What a wide tree is made of: the nodes, triangles at rest in their leaves, and other shapes beside them.
class WideContents {
public:
    explicit WideContents(const Scene& scene);

    std::size_t bytes() const;

    Primitive primitive(std::uint32_t number) const;     // of a triangle: WideNodes::number()
    std::uint32_t number_left_by(const Ray& ray) const;  // as WideQuery has it

    /// Any primitive of a leaf as diagrams number it: its place in the scene, meshes taken apart.
    std::vector<std::uint32_t> places_in_scene(WideChild leaf) const;

    const Scene& scene() const { return *scene_; }
    const Primitives& others() const { return others_; }
    const Primitives& unbounded() const { return unbounded_; }
    const WideNodes& tree() const { return tree_; }

private:
    struct Sorted;
    WideContents(const Scene& scene, const Sorted& sorted);

    // The triangles of one object, numbered from `first` on in the order they were given to the tree.
    struct Run {
        std::uint32_t first, object;
    };

    const Scene* scene_;
    std::vector<Run> runs_;
    Primitives others_, unbounded_;
    WideNodes tree_;
};

}  // namespace raylab
