#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/intersect/prepared_shape.h"
#include "raylab/scene/moving.h"
#include "raylab/tracer/shading/surface_point.h"

#include <vector>

namespace raylab {

/// The surfaces of a scene for a single ray: any shape anywhere, found by an accelerator.
class AnySurface {
public:
    AnySurface(const Scene& scene, const Accelerator& accelerator) : scene_(&scene), accelerator_(&accelerator) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const {
        return accelerator_->closest(ray, traversal);
    }
    bool occluded(const Ray& ray, Traversal& traversal) const { return accelerator_->occluded(ray, traversal); }
    SurfacePoint point(const Ray& ray, const Hit& hit) const { return surface_point(*scene_, ray, hit); }

private:
    const Scene* scene_;
    const Accelerator* accelerator_;
};

/// The same for the many rays of a picture: every surface is prepared for them.
class PreparedSurfaces {
public:
    PreparedSurfaces(const Scene& scene, const Accelerator& accelerator)
        : found_(scene, accelerator), objects_(scene.objects.data()) {
        surfaces_.reserve(scene.objects.size());
        for (const Object& object : scene.objects)
            surfaces_.emplace_back(object.shape, object.placement, motion_of(scene, object));
    }

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const { return found_.closest(ray, traversal); }
    bool occluded(const Ray& ray, Traversal& traversal) const { return found_.occluded(ray, traversal); }
    [[gnu::always_inline]] SurfacePoint point(const Ray& ray, const Hit& hit) const {
        const std::size_t i = hit.primitive.object;
        return surface_point(objects_[i], surfaces_[i].position(ray, hit), hit, ray.time);
    }

private:
    AnySurface found_;
    const Object* objects_;
    std::vector<PreparedShape> surfaces_;
};

}  // namespace raylab
