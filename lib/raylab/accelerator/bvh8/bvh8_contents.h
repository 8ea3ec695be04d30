#pragma once

#include "raylab/accelerator/bvh8/bvh8_build.h"
#include "raylab/accelerator/bvh8/bvh8_instances.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/accelerator/primitives.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace raylab {

/// The contents of bvh8: the nodes, the triangles that are not transformed, which are stored in the leaves, and
/// beside them the other shapes and the instances of meshes. (The latter follow the former in the tree's `others`.)
class Bvh8Contents {
public:
    explicit Bvh8Contents(const Scene& scene, const Bvh8BuildOptions& options = {});

    /// The same for a tree that is built otherwise. (The options are then those of the instances' trees.)
    using Build = std::function<Bvh8Nodes(const TriangleRuns&, std::span<const Box> others)>;
    Bvh8Contents(const Scene& scene, const Bvh8BuildOptions& options, const Build& build);

    std::size_t bytes() const;

    /// The name of a triangle by its Bvh8Nodes::number().
    Primitive primitive(std::uint32_t number) const {
        const Run& run = runs_.size() == 1 ? runs_[0] : run_of(number);
        const std::uint32_t in_run = number - run.first;
        if (in_run < run.triangles_each) return {run.object, in_run};  // no division for a mesh
        return {run.object + in_run / run.triangles_each, in_run % run.triangles_each};
    }
    /// For Bvh8Query::leaving.
    std::uint32_t number_left_by(const Ray& ray) const {
        return ray.leaving == no_primitive ? Bvh8Query::leaves_none : number_of(ray.leaving);
    }

    /// The primitives of a leaf as diagrams number them: by place in the scene, with each triangle of a mesh counted.
    std::vector<std::uint32_t> places_in_scene(Bvh8Child leaf) const;

    const Scene& scene() const { return *scene_; }
    const Primitives& others() const { return others_; }
    const Primitives& unbounded() const { return unbounded_; }
    const Bvh8Instances& instances() const { return instances_; }
    const Bvh8Nodes& tree() const { return tree_; }

private:
    struct Sorted;
    Bvh8Contents(const Scene& scene, Sorted sorted, const Build& build);
    std::vector<Primitive> put_in_leaf_order(Sorted& sorted);
    std::uint32_t number_of(Primitive name) const;  // leaves_none where it is no triangle of the leaves

    // Objects one after the other with as many triangles each, which are numbered from `first` on in the order in which
    // they were given to the tree.
    struct Run {
        std::uint32_t first, object, triangles_each;
    };

    const Run& run_of(std::uint32_t number) const;

    const Scene* scene_;
    std::vector<Run> runs_;
    Bvh8Nodes tree_;
    Primitives others_, unbounded_;
    Bvh8Instances instances_;
};

}  // namespace raylab
