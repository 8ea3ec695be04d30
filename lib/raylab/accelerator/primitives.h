#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/box.h"
#include "raylab/geometry/nearest.h"
#include "raylab/scene/scene.h"

#include <optional>
#include <vector>

namespace raylab {

/// The primitives of a scene in their order, meshes taken apart into triangles: what every accelerator holds and tests.
class Primitives {
public:
    explicit Primitives(const Scene& scene);

    std::size_t size() const { return primitives_.size(); }
    std::optional<Box> bounds(std::size_t i) const;  // absent: unbounded
    std::size_t bytes() const;

    /// Offers the hit of primitive i, if there is one, to `nearest`.
    void test(std::size_t i, const Ray& ray, Nearest& nearest, Traversal& traversal) const;

    /// Whether the ray hits primitive i.
    bool hits(std::size_t i, const Ray& ray, Traversal& traversal) const;

private:
    Target target(Primitive primitive) const;
    std::optional<Candidate> meet(Primitive primitive, const Ray& ray, Traversal& traversal) const;

    const Scene* scene_;
    std::vector<Primitive> primitives_;
};

}  // namespace raylab
