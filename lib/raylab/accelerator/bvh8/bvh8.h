#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh8/bvh8_contents.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"

namespace raylab {

/// The default structure: eight boxes, and eight triangles, are tested at once. Triangles that are not transformed are
/// first tested in floats with an error bound, and only those that this leaves open are tested exactly; other shapes
/// are tested one by one; a mesh at a place of its own is an instance of a tree that all its places share.
class Bvh8 final : public Accelerator {
public:
    explicit Bvh8(const Scene& scene, const Bvh8BuildOptions& options = {}) : contents_(scene, options) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    /// Rays take turns where that pays.
    std::vector<std::optional<Hit>> closest_of(std::span<const Ray> rays, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::vector<bool> occluded_of(std::span<const Ray> rays, Traversal& traversal) const override;
    std::size_t bytes() const override { return contents_.bytes(); }
    Outline outline() const override;
    std::vector<Visit> visits(const Ray& ray) const override;

    /// The nearest hit by Pluecker's test in floats, through the same boxes. It is for benchmarks of meshes only, which
    /// compare the exact answer with it. It finds nothing for rays whose numbers exceed the limits of Bvh8Ray.
    std::optional<Hit> closest_in_floats(const Ray& ray, Traversal& traversal) const;

    /// The answers to several rays, of which eight are under way at once: one that has to wait for a node or leaf,
    /// which all are that lie beyond the first `near_bytes` of their kind, lets the others go on.
    std::vector<std::optional<Hit>> closest_in_turns(std::span<const Ray> rays, std::size_t near_bytes,
                                                     Traversal& traversal) const;
    std::vector<bool> occluded_in_turns(std::span<const Ray> rays, std::size_t near_bytes, Traversal& traversal) const;

private:
    // Whether rays wait so long for memory that turns pay. In a tree that fits the caches none does, in one far larger
    // than these all do. Between, a ray finds there what the one before it has read, unless most begin far apart.
    bool wait_for_memory(std::span<const Ray> rays) const;
    // So much of a tree's nodes, and of its leaves, stays in the caches.
    static constexpr std::size_t cached_bytes = std::size_t{1} << 21;

    Bvh8Contents contents_;
    Bvh8Walks walks_ = best_bvh8_walks();
};

}  // namespace raylab
