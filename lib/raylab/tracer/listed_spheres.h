#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/nearest.h"
#include "raylab/geometry/sphere_position.h"
#include "raylab/tracer/surface_point.h"

#include <span>
#include <vector>

namespace raylab {

/// What rays meet in a scene of nothing but spheres at rest where they were made, found by a list: each is asked, and none what
/// it is. The answers are the list's, the same bits, and so are the counts.
class ListedSpheres {
    struct Listed {
        Sphere sphere;
        Sides sides;
        SphereOf<double> whole;
        double error;  // of a point on it
        const Object* object;
        Primitive primitive;
    };

public:
    static constexpr bool may_be_smooth = false;

    ListedSpheres(const Scene& scene, const Accelerator&);

    struct Met {
        double t;
        const Listed* sphere;
    };

    std::optional<Met> closest(const Ray& ray, Traversal& traversal) const {
        traversal.primitive_tests += count_;
        Decisions decisions;
        const Listed* nearest = spheres_.data();
        auto found = met(*nearest, ray, decisions);
        for (const Listed& other : others_) {
            const auto also = met(other, ray, decisions);
            if (!also || (found && !is_before(ray, other, *also, *nearest, *found, decisions))) continue;
            nearest = &other;
            found = also;
        }
        traversal.exact_decisions += decisions.exact;
        if (!found) return std::nullopt;
        return Met{found->t, nearest};
    }

    SurfacePoint point(const Ray& ray, const Met& hit) const {
        const Listed& sphere = *hit.sphere;
        Vec3d near = convert<double>(ray.origin) + hit.t * convert<double>(ray.direction);
        auto [position, direction] = on_sphere(sphere.whole, near);
        Vec3d normal = glm::normalize(direction);
        return {.position = position,
                .error = sphere.error,
                .normal = normal,
                .shading_normal = normal,
                .object = sphere.object,
                .primitive = sphere.primitive};
    }

private:
    static std::optional<Candidate> met(const Listed& listed, const Ray& ray, Decisions& decisions) {
        return intersect(ray, listed.sphere, decisions, listed.sides);
    }

    // Exactly. Of two hits at one t the first in the list counts.
    static bool is_before(const Ray& ray, const Listed& a, const Candidate& at_a, const Listed& b, const Candidate& at_b,
                          Decisions& decisions);

    std::vector<Listed> spheres_;  // one or more
    std::uint64_t count_;
    std::span<const Listed> others_;  // than the first
};

}  // namespace raylab
