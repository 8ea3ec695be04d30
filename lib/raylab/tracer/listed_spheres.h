#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/plain_sphere.h"

#include <vector>

namespace raylab {

/// What rays meet where there is nothing but plain spheres, found by a list.
class ListedSpheres {
public:
    ListedSpheres(const Scene& scene, const Accelerator& list, const Lighting& lighting) : list_(list) {
        spheres_.reserve(scene.objects.size());
        for (std::uint32_t i = 0; i < scene.objects.size(); ++i) spheres_.emplace_back(scene, i, lighting);
    }

    using Memory = Traversal;

    struct Met {
        double t;
        Vec3d near;  // where the ray is at t
        std::uint32_t number;
    };

    std::optional<Met> closest(const Ray& ray, Traversal& traversal) const {
        const auto hit = list_.closest(ray, traversal);
        if (!hit) return std::nullopt;
        return Met{hit->t, convert<double>(ray.origin) + hit->t * convert<double>(ray.direction), hit->primitive.object};
    }

    const PlainSphere& sphere(const Met& hit) const { return spheres_[hit.number]; }

    /// Whether the ray, in this direction, comes to the outside.
    static bool is_outside(const Met&, const SurfacePoint& at, const Vec3d& direction) {
        return !(dot(at.normal, glm::normalize(direction)) > 0);
    }

private:
    const Accelerator& list_;
    std::vector<PlainSphere> spheres_;
};

}  // namespace raylab
