#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/surface_point.h"

namespace raylab {

/// What rays meet: any shape anywhere, found by an accelerator.
class AnySurface {
public:
    static constexpr bool may_be_smooth = true;  // a mesh that is lit by the normals of its vertices

    AnySurface(const Scene& scene, const Accelerator& accelerator) : scene_(&scene), accelerator_(&accelerator) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const { return accelerator_->closest(ray, traversal); }
    bool occluded(const Ray& ray, Traversal& traversal) const { return accelerator_->occluded(ray, traversal); }
    SurfacePoint point(const Ray& ray, const Hit& hit) const { return surface_point(*scene_, ray, hit); }

private:
    const Scene* scene_;
    const Accelerator* accelerator_;
};

}  // namespace raylab
