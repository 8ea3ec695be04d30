#pragma once

#include "raylab/accelerator/bvh8/bvh8_build.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/accelerator/bvh8/ray_in_mesh.h"
#include "raylab/geometry/intersect/nearest.h"
#include "raylab/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace raylab {

/// Meshes that are placed. Each is one box of the tree above it; the tree over a mesh's triangles is built once, in the
/// mesh's own coordinates, and all of its instances share it. (Rubin and Whitted, A 3-Dimensional Representation for
/// Fast Rendering of Complex Scenes, SIGGRAPH 1980.)
///
/// A ray that is carried into the mesh is rounded, so floats do not decide about its triangles: the walk is told how
/// far the rounded ray may be from the exact one, and what it cannot exclude is asked of the exact ray in the world.
class Bvh8Instances {
public:
    /// The options are those of the meshes' trees.
    explicit Bvh8Instances(const Scene& scene, const Bvh8BuildOptions& options = {})
        : scene_(&scene), options_(options) {}

    /// False if the object is not a mesh at a place of its own, at rest, or if floats cannot hold it.
    bool add(std::uint32_t object);

    /// The i-th is then the one that was order[i].
    void put_in_order(const std::vector<std::uint32_t>& order);

    std::size_t size() const { return instances_.size(); }
    std::uint32_t object(std::size_t i) const { return instances_[i].object; }
    const Box& bounds(std::size_t i) const { return instances_[i].bounds; }
    std::size_t bytes() const;

    /// Offers hits of instance i to `nearest`: the nearest one, unless it is beyond `end`.
    void test(std::size_t i, const Ray& ray, double end, Nearest& nearest, Traversal& traversal) const;

    /// Whether the ray hits instance i.
    bool hits(std::size_t i, const Ray& ray, Traversal& traversal) const;

private:
    struct Instance {
        std::uint32_t object;
        Sides sides;
        Box bounds;
        const Bvh8Nodes* tree;
        WorldToMesh map;
    };
    class Leaves;
    class NearestLeaves;
    class AnyLeaves;

    static std::optional<RayInMesh> carried(const Ray& ray, double end, const Instance& into);
    const Bvh8Nodes& tree_of(const std::shared_ptr<const Mesh>& mesh);
    static void walk(Bvh8Walks::Walk how, const RayInMesh& ray, Leaves& leaves, Traversal& traversal);

    const Scene* scene_;
    Bvh8BuildOptions options_;
    std::map<const Mesh*, std::unique_ptr<const Bvh8Nodes>> trees_;
    std::vector<Instance> instances_;
    Bvh8Walks walks_ = best_bvh8_walks();
};

}  // namespace raylab
